#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percuss::app {

/// A case as its price and its error; absent error: it has none to be judged by.
struct Offer {
    double price = 0;
    std::optional<double> error;
};

/// Those that no other beats in one of price and error without losing in the other, by rising price. Of equal
/// ones the first. @param least part by which an error must fall to be worth a higher price.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Offer> offers, double least = 0);

/// The cheapest whose error is at most `tolerance`.
[[nodiscard]] std::optional<std::size_t> cheapest_within(std::span<const Offer> offers, double tolerance);

}  // namespace percuss::app
