#include "study/case_result.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "output.hpp"
#include "record/summary.hpp"

namespace percuss::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array states{CaseState::finished, CaseState::diverged, CaseState::refused, CaseState::failed};

}  // namespace

const char* state_name(CaseState state) {
    switch (state) {
        case CaseState::finished:
            return "finished";
        case CaseState::diverged:
            return "diverged";
        case CaseState::refused:
            return "refused";
        case CaseState::failed:
            break;
    }
    return "failed";
}

double CaseResult::best_seconds() const {
    return seconds.empty() ? 0 : *std::min_element(seconds.begin(), seconds.end());
}

std::optional<double> CaseResult::spread() const {
    if (seconds.size() < 2 || !(best_seconds() > 0)) return std::nullopt;
    return *std::max_element(seconds.begin(), seconds.end()) / best_seconds() - 1;
}

std::optional<double> CaseResult::number(const std::string& path) const {
    return summary.is_object() ? summary_value(summary, path) : std::nullopt;
}

void write_case_result(const CaseResult& result, const std::filesystem::path& file) {
    const Json json{{"state", state_name(result.state)}, {"message", result.message},
                    {"seconds", result.seconds},         {"core_share", result.core_share},
                    {"memory", result.memory},           {"memory_before", result.memory_before},
                    {"summary", result.summary},         {"histories", result.histories}};
    write_text_file(file, json.dump() + "\n");
}

std::optional<CaseResult> read_case_result(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    try {
        const Json json = Json::parse(in);
        CaseResult result;
        const auto state = std::find_if(states.begin(), states.end(), [&](CaseState s) {
            return json.at("state").get<std::string>() == state_name(s);
        });
        if (state == states.end()) return std::nullopt;
        result.state = *state;
        json.at("message").get_to(result.message);
        json.at("seconds").get_to(result.seconds);
        json.at("core_share").get_to(result.core_share);
        json.at("memory").get_to(result.memory);
        json.at("memory_before").get_to(result.memory_before);
        json.at("histories").get_to(result.histories);
        result.summary = json.at("summary");
        return result;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace percuss::app
