#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// Words of a key's choice with what they mean.
template <class T>
using Words = std::vector<std::pair<std::string, T>>;

/// The names that schemes have in scenes, summaries and the window; nowhere else are they listed.
inline const Words<ContactScheme>& contact_scheme_words() {
    static const Words<ContactScheme> words{{"projection", ContactScheme::projection},
                                            {"joint", ContactScheme::joint},
                                            {"penalty", ContactScheme::penalty},
                                            {"bipenalty", ContactScheme::bipenalty},
                                            {"massless", ContactScheme::massless}};
    return words;
}
inline const Words<RowScheme>& row_scheme_words() {
    static const Words<RowScheme> words{{"node-to-side", RowScheme::node_to_side},
                                        {"symmetric", RowScheme::symmetric},
                                        {"segment-to-segment", RowScheme::segment_to_segment}};
    return words;
}

/// @pre the value is among the words
template <class T>
const std::string& name_of(const Words<T>& words, T value) {
    return std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.second == value; })
        ->first;
}
inline const std::string& name_of(ContactScheme scheme) { return name_of(contact_scheme_words(), scheme); }
inline const std::string& name_of(RowScheme scheme) { return name_of(row_scheme_words(), scheme); }

}  // namespace percuss
