#include "contact/pair_by_pair.hpp"

#include "run/phase_timer.hpp"

namespace percuss {

PairByPair::PairByPair(const Scene& scene, const Mesh& mesh) {
    for (const ContactPair& pair : scene.contacts) pairs_.push_back(make_contact_scheme(pair, mesh));
}

void PairByPair::resolve(PredictedMotion& motion, RunStatistics& statistics) {
    PhaseTimer timer;
    for (auto& pair : pairs_) {
        pair->find(motion);
        timer.book(statistics.seconds.contact_search);
        pair->resolve(motion);
        timer.book(statistics.seconds.contact_solve);
    }
}

std::unique_ptr<ContactMethod> PairByPair::copy() const {
    std::unique_ptr<PairByPair> method(new PairByPair);
    for (const auto& pair : pairs_) method->pairs_.push_back(pair->copy());
    return method;
}

void PairByPair::become(const ContactMethod& other) {
    const auto& method = dynamic_cast<const PairByPair&>(other);
    for (std::size_t p = 0; p < pairs_.size(); ++p) pairs_[p]->become(*method.pairs_[p]);
}

void PairByPair::restart(const std::vector<std::vector<std::int32_t>>&) {
    for (auto& pair : pairs_) pair->forget();
}

}  // namespace percuss
