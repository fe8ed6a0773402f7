#include "contact/contact_method.hpp"

#include "contact/joint/frictional_contact.hpp"
#include "contact/joint/joint_contact.hpp"
#include "contact/pair_by_pair.hpp"

namespace percuss {

std::unique_ptr<ContactMethod> make_contact_method(const Scene& scene, const Mesh& mesh,
                                                   ContactScheme scheme) {
    if (scene.contacts.empty()) return nullptr;
    if (has_friction(scene)) return std::make_unique<FrictionalContact>(scene, mesh);
    if (scheme == ContactScheme::joint) return std::make_unique<JointContact>(scene, mesh);
    return std::make_unique<PairByPair>(scene, mesh);
}

}  // namespace percuss
