#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace percuss {

/// One node's part in a contact row: a contact force C puts C g on the node, and by virtual work the row's
/// gap grows by g . v when the node moves by v.
struct RowTerm {
    std::int32_t node = 0;
    std::array<double, 2> g{};
};

/// One non-penetration condition of a pair, whatever scheme made it: a gap that is linear in the motion of
/// some nodes. The terms of the pair's first body (the master) come first; with those of the second they sum
/// to zero.
struct ContactRow {
    std::int32_t first_term = 0;  ///< among the terms of all rows
    std::int32_t terms = 0;
    std::int32_t master_terms = 0;  ///< how many of them are of the first body
    std::int32_t owner = 0;  ///< the node that the row keeps out, counted within its pair: see RowBuilder
    std::int32_t key = 0;    ///< of the row within its pair, by which it is known from step to step
    std::int32_t side = 0;   ///< that keeps it out, within its surface; -1: several
    double penetration = 0;  ///< P of the predicted motion [length]
    double margin = 0;       ///< the row bears force only if it would close by more than this [length]
    double force = 0;        ///< C, per radian or unit thickness [force]
};

/// Some rows with their terms, to look at.
struct RowSpan {
    std::span<const ContactRow> rows;
    const RowTerm* all_terms = nullptr;

    [[nodiscard]] auto begin() const { return rows.begin(); }
    [[nodiscard]] auto end() const { return rows.end(); }
    [[nodiscard]] std::size_t size() const { return rows.size(); }
    [[nodiscard]] bool empty() const { return rows.empty(); }
    [[nodiscard]] const ContactRow& operator[](std::size_t k) const { return rows[k]; }
    [[nodiscard]] std::span<const RowTerm> terms(const ContactRow& row) const {
        return {all_terms + row.first_term, static_cast<std::size_t>(row.terms)};
    }
};

/// Rows in the order in which they were made, and their terms, back to back.
class ContactRows {
  public:
    void reserve(std::size_t rows, std::size_t terms) {
        rows_.reserve(rows);
        terms_.reserve(terms);
    }
    void clear() {
        rows_.clear();
        terms_.clear();
    }
    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] ContactRow& operator[](std::size_t k) { return rows_[k]; }
    [[nodiscard]] const ContactRow& operator[](std::size_t k) const { return rows_[k]; }
    [[nodiscard]] auto begin() const { return rows_.begin(); }
    [[nodiscard]] auto end() const { return rows_.end(); }
    [[nodiscard]] auto begin() { return rows_.begin(); }
    [[nodiscard]] auto end() { return rows_.end(); }
    [[nodiscard]] std::span<const RowTerm> terms(const ContactRow& row) const {
        return {terms_.data() + row.first_term, static_cast<std::size_t>(row.terms)};
    }
    [[nodiscard]] RowSpan part(std::size_t from, std::size_t to) const {
        return {std::span(rows_).subspan(from, to - from), terms_.data()};
    }
    [[nodiscard]] RowSpan all() const { return part(0, size()); }

    /// A new row without terms; add_term gives it some. The reference holds until the next call.
    ContactRow& add_row() {
        ContactRow& row = rows_.emplace_back();
        row.first_term = static_cast<std::int32_t>(terms_.size());
        return row;
    }
    void add_term(ContactRow& row, std::int32_t node, double gx, double gy) {
        terms_.push_back({node, {gx, gy}});
        ++row.terms;
    }
    /// The row of the friction force that goes with a contact row: every direction turned by 90 degrees.
    ContactRow& add_turned(const RowSpan& from, const ContactRow& row) {
        ContactRow& turned = rows_.emplace_back(row);
        turned.first_term = static_cast<std::int32_t>(terms_.size());
        for (const RowTerm& term : from.terms(row)) terms_.push_back({term.node, {-term.g[1], term.g[0]}});
        return turned;
    }

  private:
    std::vector<ContactRow> rows_;
    std::vector<RowTerm> terms_;
};

/// How a vector of the nodes acts along a row: the gap rate, by velocities. @param of node -> pointer to its
/// two components.
template <class VectorOf>
[[nodiscard]] double along(std::span<const RowTerm> terms, VectorOf of) {
    double sum = 0;
    for (const RowTerm& term : terms) {
        const auto v = of(term.node);
        sum += term.g[0] * v[0] + term.g[1] * v[1];
    }
    return sum;
}

}  // namespace percuss
