#include <algorithm>

#include "figures/axes.hpp"
#include "figures/panels.hpp"

namespace percuss::render {

void paint_table(Canvas& canvas, const Table& table, const Rect& rect, double scale) {
    const double heading = paint_panel_title(canvas, rect, table.title, scale);
    const std::size_t columns = table.header.size();
    const auto lines = static_cast<double>(table.rows.size() + 1);
    // Rows shrink before they would run out of their rectangle.
    const double row = std::min(24 * scale, (rect.height - heading - 6 * scale) / lines);
    TextStyle style{std::min(13 * scale, 0.75 * row)};
    std::vector<double> widths(columns, 0);
    const auto measure = [&](const std::vector<std::string>& cells, bool bold) {
        TextStyle of = style;
        of.bold = bold;
        for (std::size_t c = 0; c < std::min(columns, cells.size()); ++c)
            widths[c] = std::max(widths[c], canvas.text_size(cells[c], of)[0]);
    };
    measure(table.header, true);
    for (const auto& cells : table.rows) measure(cells, false);
    double needed = 0;
    for (const double width : widths) needed += width + 18 * scale;
    if (needed > rect.width) {
        const double shrink = rect.width / needed;
        style.size *= shrink;
        for (double& width : widths) width *= shrink;
        needed = rect.width;
    }
    const double gap =
        columns > 1 ? std::min((rect.width - needed) / static_cast<double>(columns - 1), 40 * scale) : 0;
    const double right = std::min(rect.right(), rect.x + needed + gap * static_cast<double>(columns - 1));
    double y = rect.top() - heading - 0.5 * row;
    const auto paint = [&](const std::vector<std::string>& cells, bool bold) {
        double x = rect.x;
        for (std::size_t c = 0; c < std::min(columns, cells.size()); ++c) {
            TextStyle of = style;
            of.bold = bold;
            of.align = c == 0 ? Align::left : Align::right;
            canvas.text(c == 0 ? x : x + widths[c], y, cells[c], of);
            x += widths[c] + 18 * scale + gap;
        }
        y -= row;
    };
    paint(table.header, true);
    canvas.line(rect.x, y + 0.5 * row, right, y + 0.5 * row, ink::soft, scale);
    for (const auto& cells : table.rows) {
        paint(cells, false);
        canvas.line(rect.x, y + 0.5 * row, right, y + 0.5 * row, ink::grid, scale);
    }
}

}  // namespace percuss::render
