#include "study/pareto.hpp"

#include <algorithm>
#include <limits>

namespace percuss::app {

std::vector<std::size_t> pareto_front(std::span<const Offer> offers, double least) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (offers[i].error) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (offers[a].price != offers[b].price) return offers[a].price < offers[b].price;
        return *offers[a].error < *offers[b].error;
    });
    std::vector<std::size_t> front;
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (*offers[i].error >= (1 - least) * best) continue;
        best = *offers[i].error;
        front.push_back(i);
    }
    return front;
}

std::optional<std::size_t> cheapest_within(std::span<const Offer> offers, double tolerance) {
    std::optional<std::size_t> cheapest;
    for (std::size_t i = 0; i < offers.size(); ++i)
        if (offers[i].error && *offers[i].error <= tolerance &&
            (!cheapest || offers[i].price < offers[*cheapest].price))
            cheapest = i;
    return cheapest;
}

}  // namespace percuss::app
