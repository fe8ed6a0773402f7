#include "contact/scheme.hpp"

#include "contact/schemes/projection.hpp"

namespace percuss {

std::unique_ptr<PairScheme> make_contact_scheme(const ContactPair& pair, const Mesh& mesh) {
    PenetrationSearch search(make_surface(mesh, pair.master), make_surface(mesh, pair.slave));
    return std::make_unique<Projection>(std::move(search), pair.sign, mesh.node_count());
}

}  // namespace percuss
