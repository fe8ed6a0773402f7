#include "run/energy_budget.hpp"

#include <array>
#include <utility>

namespace percuss {

std::vector<EnergyShare> energy_budget(const Snapshot& snapshot) {
    std::vector<EnergyShare> shares;
    if (snapshot.body_energies.empty()) return shares;
    constexpr std::array<std::pair<const char*, double BodyEnergies::*>, 5> kinds{
        {{"kinetic", &BodyEnergies::kinetic},
         {"elastic", &BodyEnergies::elastic},
         {"plastic", &BodyEnergies::plastic},
         {"hourglass", &BodyEnergies::hourglass},
         {"viscous", &BodyEnergies::viscous}}};
    double sum = 0;
    const auto add = [&](const std::string& kind, const std::string& body, double energy) {
        shares.push_back({kind, body, energy});
        sum += energy;
    };
    for (const auto& [kind, energy] : kinds)
        for (std::size_t b = 0; b < snapshot.body_energies.size(); ++b)
            add(kind, snapshot.setup->scene.bodies[b].name, snapshot.body_energies[b].*energy);
    add("contact", "", -snapshot.energy.contact);
    if (has_friction(snapshot.setup->scene)) add("friction", "", -snapshot.energy.friction);
    add("unaccounted", "", snapshot.energy.external - sum);
    return shares;
}

}  // namespace percuss
