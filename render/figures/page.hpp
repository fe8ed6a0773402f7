#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "figures/figure.hpp"
#include "run/snapshot.hpp"

namespace percuss::render {

/// Values over two axes as colours, with a colour bar.
struct HeatMap {
    std::string title, x_title, y_title, value_title;  ///< with units
    std::vector<double> x, y;  ///< ascending places of the samples; each fills to half way to its neighbours
    std::vector<double> values;  ///< x.size() * y.size(), y running fastest; NaN stays white
    std::optional<std::array<double, 2>> x_range, y_range,
        range;  ///< range absent: of the values, for "coolwarm" symmetric
    std::string colour_map = "viridis";
};

/// Shares of a sum over x, one upon the other; negative ones hang below zero.
struct StackedAreas {
    struct Layer {
        std::string label;
        std::vector<double> y;  ///< as many as x
    };
    std::string title, x_title, y_title;
    std::vector<double> x;
    std::vector<Layer> layers;  ///< lowest first
    std::optional<std::array<double, 2>> y_range;
};

/// Horizontal bars in groups, each with its number.
struct Bars {
    struct Group {
        std::string label;
        std::vector<double> values;      ///< one a series
        std::vector<std::string> texts;  ///< written at the ends of the bars
    };
    std::string title, x_title;
    std::vector<std::string> series;  ///< for the legend; one series needs none
    std::vector<Group> groups;        ///< topmost first
    bool by_group = false;            ///< colours tell groups, not series
};

/// The deformed mesh at one time, mirrored as the options say, cut at options.window.
struct MeshPicture {
    std::string title;
    std::shared_ptr<const Snapshot> snapshot;
    ViewOptions options;    ///< field, range, colour map, window, mirror, up, edges
    bool coloured = false;  ///< by the field; else each body in a pale colour of its own
    bool colour_bar = false, scale_bar = false;
    static constexpr double colour_bar_room = 70, scale_bar_room = 48;
    double room_below = 0;  ///< for the bars, alike in all pictures of a row [pixels at type 1]
};

struct Table {
    std::string title;
    std::vector<std::string> header;             ///< one a column
    std::vector<std::vector<std::string>> rows;  ///< first column to the left, others to the right
};

/// Points in logarithmic axes: prices and errors, sizes and errors.
struct Scatter {
    struct Series {
        std::string label;         ///< for the legend
        std::vector<double> x, y;  ///< those that are not positive are left out
        std::size_t colour = 0;    ///< index into the palette of curves
        bool joined = false;       ///< by a line, in their order
    };
    struct Note {
        double x = 0, y = 0;  ///< the point that it is about
        std::string text;
    };
    std::string title, x_title, y_title;
    std::vector<Series> series;
    std::vector<double> front_x, front_y;  ///< a line of steps behind the points: nothing lies below it
    std::vector<Note> notes;
    std::optional<double> limit;  ///< a level line, with `limit_label`
    std::string limit_label;
};

using Panel = std::variant<Chart, HeatMap, StackedAreas, Bars, MeshPicture, Table, Scatter>;

/// Panels on one sheet of paper.
struct Page {
    struct Placed {
        Panel panel;
        std::array<double, 4> place{0, 0, 1,
                                    1};  ///< left, top, width, height: fractions of the sheet below its title
    };
    std::string title;
    std::vector<Placed> panels;
    int width = 1600, height = 1000;  ///< pixels
    double type = 1.5;                ///< size of type: 1.5 makes letters of about 20 pixels
};

/// @throws RenderError for a page without size, or a field or colour map that does not exist.
[[nodiscard]] Image draw_page(Context& context, const Page& page);

/// The colour of layer or group `index` in areas and bars, 0xRRGGBB.
[[nodiscard]] unsigned area_colour(std::size_t index);

}  // namespace percuss::render
