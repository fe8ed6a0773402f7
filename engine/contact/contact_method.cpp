#include "contact/contact_method.hpp"

#include "contact/joint/frictional_contact.hpp"
#include "contact/joint/joint_contact.hpp"
#include "contact/joint/massless_contact.hpp"
#include "contact/pair_by_pair.hpp"

namespace percuss {

namespace {

template <class Normal>
std::unique_ptr<ContactMethod> make(const Scene& scene, const Mesh& mesh) {
    if (has_friction(scene)) return std::make_unique<FrictionalContact<Normal>>(scene, mesh);
    return std::make_unique<Normal>(scene, mesh);
}

}  // namespace

std::unique_ptr<ContactMethod> make_contact_method(const Scene& scene, const Mesh& mesh,
                                                   ContactScheme scheme) {
    if (scene.contacts.empty()) return nullptr;
    switch (scheme) {
        case ContactScheme::joint:
            return make<JointContact>(scene, mesh);
        case ContactScheme::penalty:
            return make<PenaltyContact>(scene, mesh);
        case ContactScheme::bipenalty:
            return make<BipenaltyContact>(scene, mesh);
        case ContactScheme::massless:
            return std::make_unique<MasslessContact>(scene, mesh);
        case ContactScheme::projection:
            break;
    }
    // Friction needs the joint problem; a run with it cannot leave it.
    if (has_friction(scene)) return make<JointContact>(scene, mesh);
    return std::make_unique<PairByPair>(scene, mesh);
}

}  // namespace percuss
