#include "workbench/layout.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace percuss::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t most_recent = 20, most_entries = 500;

std::optional<double> number(const json& value, double low, double high) {
    if (!value.is_number()) return std::nullopt;
    const double x = value.get<double>();
    if (!(x >= low && x <= high)) return std::nullopt;
    return x;
}

/// The XDG base directory specification: a variable that is no absolute path counts as unset.
std::optional<fs::path> base_folder(const char* variable, const char* below_home) {
    const char* set = std::getenv(variable);
    if (set != nullptr && fs::path(set).is_absolute()) return fs::path(set) / "percuss";
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return std::nullopt;
    return fs::path(home) / below_home / "percuss";
}

}  // namespace

void WindowLayout::remember(const fs::path& file) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(file, ignored).lexically_normal();
    std::erase(recent, whole);
    recent.insert(recent.begin(), whole);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

std::string layout_text(const WindowLayout& layout) {
    json tree = json::object();
    if (layout.left) tree["left"] = *layout.left;
    if (layout.right) tree["right"] = *layout.right;
    if (layout.scale) tree["scale"] = *layout.scale;
    if (layout.dark) tree["dark"] = *layout.dark;
    if (layout.window) tree["window"] = *layout.window;
    tree["plots"] = layout.plots;
    tree["curves"] = layout.curves;
    json sections = json::object();
    for (const auto& [id, open] : layout.sections) sections[std::to_string(id)] = open;
    tree["sections"] = std::move(sections);
    json recent = json::array();
    for (const fs::path& file : layout.recent) recent.push_back(file.string());
    tree["recent"] = std::move(recent);
    return tree.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

WindowLayout parse_layout(const std::string& text) {
    json tree;
    try {
        tree = json::parse(text);
    } catch (const json::parse_error& error) {
        throw LayoutError(fmt::format("is no JSON (byte {})", error.byte));
    }
    if (!tree.is_object()) throw LayoutError("is no JSON object");
    const auto part = [&](const char* key) { return tree.contains(key) ? tree[key] : json(); };
    WindowLayout layout;
    layout.left = number(part("left"), 1, 1000);
    layout.right = number(part("right"), 1, 1000);
    layout.scale = number(part("scale"), 0.5, 4);
    if (part("dark").is_boolean()) layout.dark = part("dark").get<bool>();
    if (const json size = part("window"); size.is_array() && size.size() == 2) {
        const auto width = number(size[0], 64, 16384), height = number(size[1], 64, 16384);
        if (width && height) layout.window = {static_cast<int>(*width), static_cast<int>(*height)};
    }
    const auto entries = [&](const char* key, const auto& take) {
        std::size_t count = 0;
        const json values = part(key);
        if (!values.is_array() && !values.is_object()) return;
        for (const auto& [name, value] : values.items())
            if (++count <= most_entries) take(name, value);
    };
    entries("plots", [&](const std::string& name, const json& open) {
        if (open.is_boolean()) layout.plots[name] = open.get<bool>();
    });
    entries("curves", [&](const std::string&, const json& name) {
        if (name.is_string()) layout.curves.insert(name.get<std::string>());
    });
    entries("sections", [&](const std::string& name, const json& open) {
        unsigned id = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), id);
        if (error == std::errc() && end == name.data() + name.size() && open.is_boolean())
            layout.sections[id] = open.get<bool>();
    });
    entries("recent", [&](const std::string&, const json& file) {
        if (file.is_string() && layout.recent.size() < most_recent)
            layout.recent.emplace_back(file.get<std::string>());
    });
    return layout;
}

WindowLayout read_layout(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    std::ifstream in(file, std::ios::binary);
    if (!in || !fs::is_regular_file(file, ignored))
        throw LayoutError(fmt::format("{}: cannot be read", file.string()));
    try {
        return parse_layout({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
    } catch (const LayoutError& error) {
        throw LayoutError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

std::optional<fs::path> layout_file() {
    const auto folder = base_folder("XDG_STATE_HOME", ".local/state");
    return folder ? std::optional(*folder / "window.json") : std::nullopt;
}

std::optional<fs::path> thumbnail_folder() {
    const auto folder = base_folder("XDG_CACHE_HOME", ".cache");
    return folder ? std::optional(*folder / "thumbnails") : std::nullopt;
}

}  // namespace percuss::app
