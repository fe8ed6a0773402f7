#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <imgui.h>

#include "figures/ticks.hpp"
#include "workbench/panels/panel.hpp"
#include "workbench/shown_curves.hpp"

namespace percuss::app {
namespace {

/// Okabe & Ito's colours, which colour-blind eyes tell apart, and darker ones of them for the ninth curve on.
constexpr std::array<ImU32, 14> palette{
    IM_COL32(0, 114, 178, 255),   IM_COL32(213, 94, 0, 255),   IM_COL32(0, 158, 115, 255),
    IM_COL32(204, 121, 167, 255), IM_COL32(230, 159, 0, 255),  IM_COL32(86, 180, 233, 255),
    IM_COL32(120, 120, 120, 255), IM_COL32(190, 175, 20, 255), IM_COL32(0, 70, 110, 255),
    IM_COL32(140, 60, 0, 255),    IM_COL32(0, 95, 70, 255),    IM_COL32(130, 70, 105, 255),
    IM_COL32(150, 100, 0, 255),   IM_COL32(50, 110, 145, 255)};

constexpr ImU32 shown_moment_colour = IM_COL32(224, 32, 32, 255);

void flip(std::set<std::string>& names, const std::string& name) {
    if (names.erase(name) == 0) names.insert(name);
}

/// What a curve's name is about: the pair of contact plots is marked in the picture while it is pointed at.
void point_at_pair(Workbench& w, const CurveInfo& curve) {
    if (!ImGui::IsItemHovered() || curve.own) return;
    if (!w.plots.columns[curve.column].name.starts_with("contact.")) return;
    const auto& contacts = w.run.snapshot()->setup->scene.contacts;
    for (std::size_t p = 0; p < contacts.size(); ++p)
        if (contacts[p].name == curve.label) w.marks.hovered_pair = p;
}

/// Curve names that wrap at the panel's width; a click shows or hides a curve.
void show_legend(Workbench& w, const PlotInfo& plot) {
    PlotsState& state = w.plots;
    const float em = ImGui::GetFontSize(), right = ImGui::GetWindowContentRegionMax().x;
    float x = 0;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const CurveInfo& curve = plot.curves[i];
        const std::string label = shortened(curve.label, right - 2.3F * em);
        const float width = ImGui::CalcTextSize(label.c_str()).x + 1.7F * em;
        if (i > 0 && x + width + 0.4F * em < right) ImGui::SameLine(0, 0.4F * em);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetTextLineHeight();
        const std::string id = fmt::format("{}/{}", plot.name, curve.label);
        if (ImGui::InvisibleButton(id.c_str(), {width, height}))
            flip(state.toggled, id), w.layout.curves = state.toggled;
        w.names.name("plots." + id);
        x = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
        const bool on = shown(state, plot, curve);
        const ImU32 colour = palette[i % palette.size()];
        ImDrawList& ink = *ImGui::GetWindowDrawList();
        const ImVec2 low{at.x + 0.2F * em, at.y + 0.5F * height - 0.14F * em},
            high{low.x + em, low.y + 0.28F * em};
        if (on)
            ink.AddRectFilled(low, high, colour);
        else
            ink.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_TextDisabled));
        ink.AddText({at.x + 1.5F * em, at.y}, ImGui::GetColorU32(on ? ImGuiCol_Text : ImGuiCol_TextDisabled),
                    label.c_str());
        point_at_pair(w, curve);
        explain_tooltip(curve.label, (label == curve.label ? "" : curve.label + "\n") +
                                         (on ? "Click: hide this curve." : "Click: show this curve."));
    }
}

/// Colours of the runs beside go on where those of the run itself end.
ImU32 beside_colour(const PlotInfo& plot, std::size_t curve, std::size_t run) {
    return palette[(curve + (run + 1) * plot.curves.size()) % palette.size()];
}

/// Which curve is of which run beside: a line each.
void show_beside_legend(const Workbench& w, const PlotInfo& plot) {
    const float em = ImGui::GetFontSize(), height = ImGui::GetTextLineHeight();
    for (std::size_t b = 0; b < w.beside.size(); ++b) {
        ImDrawList& ink = *ImGui::GetWindowDrawList();
        ImVec2 at = ImGui::GetCursorScreenPos();
        for (std::size_t i = 0; i < plot.curves.size(); ++i) {
            if (!shown(w.plots, plot, plot.curves[i])) continue;
            ink.AddRectFilled({at.x + 0.2F * em, at.y + 0.5F * height - 0.14F * em},
                              {at.x + 1.2F * em, at.y + 0.5F * height + 0.14F * em},
                              beside_colour(plot, i, b));
            at.x += 1.3F * em;
        }
        ImGui::Dummy({at.x - ImGui::GetCursorScreenPos().x, height});
        ImGui::SameLine(0, 0.2F * em);
        ImGui::TextUnformatted(w.beside[b].run->label().c_str());
    }
}

/// Where numbers lie on the screen.
struct Axes {
    ImVec2 low, high;  // corners of the plotting area: left top, right bottom
    double from, to, least, greatest;
    [[nodiscard]] float x(double time) const {
        return low.x + static_cast<float>((time - from) / (to - from)) * (high.x - low.x);
    }
    [[nodiscard]] float y(double value) const {
        return high.y - static_cast<float>((value - least) / (greatest - least)) * (high.y - low.y);
    }
    [[nodiscard]] double time(float at) const { return from + (to - from) * (at - low.x) / (high.x - low.x); }
};

void draw_grid(ImDrawList& ink, const Axes& axes, double time_scale, const DisplayUnit& unit,
               bool time_labels) {
    const float em = ImGui::GetFontSize();
    const ImU32 grid = ImGui::GetColorU32(ImGuiCol_Border, 0.45F),
                text = ImGui::GetColorU32(ImGuiCol_Text, 0.75F);
    const auto across =
        render::make_ticks(unit.scale * axes.least, unit.scale * axes.greatest,
                           std::max(3, static_cast<int>((axes.high.y - axes.low.y) / (1.7F * em))));
    for (std::size_t i = 0; i < across.values.size(); ++i) {
        const float y = std::round(axes.y(across.values[i] / unit.scale));
        ink.AddLine({axes.low.x, y}, {axes.high.x, y}, grid);
        const ImVec2 size = ImGui::CalcTextSize(across.labels[i].c_str());
        ink.AddText({axes.low.x - size.x - 0.35F * em, y - 0.5F * size.y}, text, across.labels[i].c_str());
    }
    const auto along =
        render::make_ticks(time_scale * axes.from, time_scale * axes.to,
                           std::max(2, static_cast<int>((axes.high.x - axes.low.x) / (4.5F * em))));
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const float x = std::round(axes.x(along.values[i] / time_scale));
        ink.AddLine({x, axes.low.y}, {x, axes.high.y}, grid);
        if (!time_labels) continue;
        const ImVec2 size = ImGui::CalcTextSize(along.labels[i].c_str());
        ink.AddText({std::min(x - 0.5F * size.x, axes.high.x - size.x), axes.high.y + 0.15F * em}, text,
                    along.labels[i].c_str());
    }
    ink.AddRect(axes.low, axes.high, ImGui::GetColorU32(ImGuiCol_Border));
}

/// In pieces that turn by less than a right angle: ImGui's joints make sharp turns, of which chatter
/// consists, thin to nothing.
void add_line(const std::vector<ImVec2>& line, ImU32 colour, float width, ImDrawList& ink) {
    std::size_t begin = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const bool last = i + 1 == line.size();
        const bool turns = !last && (line[i].x - line[i - 1].x) * (line[i + 1].x - line[i].x) +
                                            (line[i].y - line[i - 1].y) * (line[i + 1].y - line[i].y) <
                                        0;
        if (!turns && !last) continue;
        ink.AddPolyline(line.data() + begin, static_cast<int>(i - begin + 1), colour, 0, width);
        begin = i;
    }
}

void draw_curve(const Workbench& w, const PlotInfo& plot, const Curves& curves, const MinMaxPyramid& values,
                const Axes& axes, ImU32 colour, float width, ImDrawList& ink) {
    static thread_local std::vector<CurvePoint> points;
    static thread_local std::vector<std::array<float, 2>> line;
    static thread_local std::vector<ImVec2> drawn;
    const int parts = std::max(1, static_cast<int>(axes.high.x - axes.low.x));
    if (plot.rate)
        rates(curves, values, axes.from, axes.to, parts_of_rate(axes.high.x - axes.low.x), rate_window(w),
              points);
    else
        decimate(curves, values, axes.from, axes.to, parts, points);
    line.clear();
    for (const CurvePoint& point : points) line.push_back({axes.x(point.time), axes.y(point.value)});
    straighten(line, 0.3F);  // the software renderer's time goes by triangles
    drawn.clear();
    for (const auto& [x, y] : line) drawn.emplace_back(x, y);
    add_line(drawn, colour, width, ink);
}

void draw_curves(Workbench& w, const PlotInfo& plot, const Axes& axes, ImDrawList& ink) {
    const auto width = static_cast<float>(1.4 * w.screen.scale());
    constexpr ImU32 faint = IM_COL32(255, 255, 255, 80);
    for (const CurveInfo& curve : plot.curves) {  // beneath, wide and pale
        const auto column = reference_column(w, curve);
        if (!column || !shown(w.plots, plot, curve)) continue;
        const ImU32 colour = palette[static_cast<std::size_t>(&curve - plot.curves.data()) % palette.size()];
        draw_curve(w, plot, w.reference->curves, w.reference->curves.column(*column), axes,
                   colour & (faint | ~IM_COL32_A_MASK), 2.5F * width, ink);
    }
    for (std::size_t i = plot.curves.size(); i-- > 0;) {  // the first on top
        const CurveInfo& curve = plot.curves[i];
        if (!shown(w.plots, plot, curve)) continue;
        Curves& curves = curves_of(w.plots, curve);
        draw_curve(w, plot, curves, curves.column(curve.column), axes, palette[i % palette.size()], width,
                   ink);
    }
    // Above: chatter would cover them.
    for (std::size_t b = w.beside.size(); b-- > 0;)
        for (std::size_t i = plot.curves.size(); i-- > 0;) {
            BesideRun& run = *w.beside[b].run;
            const auto column = beside_column(w, run, plot.curves[i]);
            if (!column || !shown(w.plots, plot, plot.curves[i])) continue;
            draw_curve(w, plot, run.curves(), run.curves().column(*column), axes, beside_colour(plot, i, b),
                       width, ink);
        }
}

/// The last row at or before a time.
std::size_t row_before(const Curves& curves, double time) {
    const std::size_t next = curves.row_at(time);
    return next > 0 && (next == curves.rows() || curves.times()[next] > time) ? next - 1 : next;
}

/// The number, or between which numbers it was.
std::string value_at(const Units& units, Quantity quantity, const MinMaxPyramid& column, std::size_t row) {
    const MinMax known =
        row < column.thinned() ? column.range(row, row + 1) : MinMax{column[row], column[row]};
    const std::string low = quantity_text(units, quantity, known.low);
    return known.low < known.high ? low + " to " + quantity_text(units, quantity, known.high) : low;
}

/// What the curves show there: the last values at or before a time.
void tell_values(Workbench& w, const PlotInfo& plot, double time) {
    if (w.plots.curves.rows() == 0) return;
    const Units& units = w.run.snapshot()->setup->scene.units;
    ImGui::BeginTooltip();
    const double row_time = w.plots.curves.times()[row_before(w.plots.curves, time)];
    ImGui::TextUnformatted(fmt::format("t = {}", quantity_text(units, Quantity::time, row_time)).c_str());
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const CurveInfo& curve = plot.curves[i];
        Curves& curves = curves_of(w.plots, curve);
        if (!shown(w.plots, plot, curve) || curves.rows() == 0) continue;
        const MinMaxPyramid& column = curves.column(curve.column);
        std::string value;
        if (plot.rate) {
            const DisplayUnit unit = unit_of(w, plot, 0);
            value =
                fmt::format("{} {}, {:.0f} so far",
                            render::format_number(unit.scale * rate_at(curves, column, time, rate_window(w))),
                            unit.label, column[row_before(curves, time)]);
        } else {
            value = value_at(units, plot.quantity, column, row_before(curves, time));
        }
        const std::string text = fmt::format("{}  {}", curve.label, value);
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette[i % palette.size()]), "%s", text.c_str());
    }
    if (row_before(w.plots.curves, time) < w.plots.curves.times().thinned())
        ImGui::TextDisabled("of a run this long, least and greatest of some steps");
    ImGui::EndTooltip();
}

/// "1234 so far", of a plot of events; "" of others.
std::string total_of(Workbench& w, const PlotInfo& plot) {
    const std::size_t rows = w.plots.curves.rows();
    if (!plot.rate || rows == 0) return "";
    double total = 0;
    for (const CurveInfo& curve : plot.curves) total += w.plots.curves.column(curve.column)[rows - 1];
    return fmt::format("{:.0f} so far", total);
}

/// Title and unit, and the total where there is room; of a title that is too long the unit stays.
std::string title_of(const PlotInfo& plot, const DisplayUnit& unit, const std::string& total, float room) {
    const std::string of = unit.label.empty() ? "" : fmt::format(" [{}]", unit.label);
    const std::string longer = plot.title + of + ", " + total;
    if (!total.empty() && ImGui::CalcTextSize(longer.c_str()).x < room) return longer;
    return shortened(plot.title, room - ImGui::CalcTextSize(of.c_str()).x) + of;
}

void navigate(Workbench& w, const PlotInfo& plot, const Axes& axes) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
        const double by = axes.time(io.MousePos.x - io.MouseDelta.x) - axes.time(io.MousePos.x);
        if (by != 0) w.plots.time = {axes.from + by, axes.to + by};
    } else if (hovered && io.MouseWheel != 0) {
        const double at = axes.time(io.MousePos.x), factor = std::pow(0.8, io.MouseWheel);
        w.plots.time = {at + (axes.from - at) * factor, at + (axes.to - at) * factor};
    } else if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        w.plots.time.reset();
    }
    if (!hovered) return;
    w.plots.cursor = axes.time(io.MousePos.x);
    if (!ImGui::IsItemActive()) tell_values(w, plot, *w.plots.cursor);
}

/// What can be done with a plot, at the right end of its title.
void show_plot_menu(Workbench& w, const PlotInfo& plot) {
    const std::string id = plot.name + ".menu", name = "plots." + id;
    ImGui::SameLine();
    if (ImGui::SmallButton(fmt::format("\u2026##{}", id).c_str())) ImGui::OpenPopup(id.c_str());
    w.names.name(name);
    tooltip("Writes this plot to a file.");
    if (!ImGui::BeginPopup(id.c_str())) return;
    const auto item = [&](const char* label, const char* end, PlotFormat format, const char* help) {
        if (ImGui::MenuItem(label)) w.exports.save_plot(w, plot, format);
        w.names.name(name + end);
        tooltip(help);
    };
    item("Curves as CSV", ".csv", PlotFormat::csv, "The visible curves, every step within the times shown.");
    item("Picture as PNG", ".png", PlotFormat::png, "The visible curves within the times shown, for print.");
    ImGui::EndPopup();
}

void show_plot(Workbench& w, const PlotInfo& plot, float height, const std::array<double, 2>& times,
               bool last, std::optional<double> cursor) {
    const float em = ImGui::GetFontSize();
    const Units& units = w.run.snapshot()->setup->scene.units;
    const auto values = shown_values(w, plot, times, ImGui::GetContentRegionAvail().x - 3.6F * em);
    const DisplayUnit unit = unit_of(w, plot, std::max(std::abs(values[0]), std::abs(values[1])));
    const bool open = !w.plots.folded.contains(plot.name);
    const std::string total = total_of(w, plot);
    ImGui::PushFont(w.screen.fonts().bold);
    const float room = open ? ImGui::GetContentRegionAvail().x - 2 * em : 0;
    const std::string title =
        title_of(plot, unit, total, ImGui::GetContentRegionAvail().x - (open ? 3.2F : 1.2F) * em);
    if (ImGui::Selectable(fmt::format("{} {}###{}", open ? "\u2013" : "+", title, plot.name).c_str(), false,
                          0, {room, 0}))
        flip(w.plots.folded, plot.name), w.layout.plots[plot.name] = !open;
    ImGui::PopFont();
    w.names.name("plots." + plot.name + ".title");
    const bool whole = title.starts_with(plot.title);
    explain_tooltip(plot.title, whole ? total : plot.title + (total.empty() ? "" : "\n" + total));
    if (!open) return;
    show_plot_menu(w, plot);
    const float top = ImGui::GetCursorPosY();
    show_legend(w, plot);
    show_beside_legend(w, plot);
    const float used = ImGui::GetCursorPosY() - top;
    const float below = last ? 2.5F * em : 0.4F * em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const Axes axes{{at.x + 3.6F * em, at.y + 2},
                    {at.x + width - 2, at.y + std::max(height - used - below, 4 * em)},
                    times[0],
                    times[1],
                    values[0],
                    values[1]};
    ImDrawList& ink = *ImGui::GetWindowDrawList();
    const DisplayUnit time = units.display(Quantity::time, w.run.snapshot()->setup->scene.duration);
    ink.AddRectFilled(axes.low, axes.high, w.screen.dark() ? IM_COL32(12, 14, 17, 255) : IM_COL32_WHITE);
    draw_grid(ink, axes, time.scale, unit, last);
    if (last) {
        const std::string label = fmt::format("time [{}]", time.label);
        ink.AddText({0.5F * (axes.low.x + axes.high.x - ImGui::CalcTextSize(label.c_str()).x),
                     axes.high.y + 1.25F * em},
                    ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    }
    ink.PushClipRect(axes.low, axes.high, true);
    draw_curves(w, plot, axes, ink);
    if (cursor)
        ink.AddLine({axes.x(*cursor), axes.low.y}, {axes.x(*cursor), axes.high.y},
                    ImGui::GetColorU32(ImGuiCol_Text, 0.6F));
    if (!w.run.live()) {                                             // the moment that the picture shows
        const float x = std::round(axes.x(w.run.snapshot()->time));  // its colour is whole on a whole pixel
        ink.AddLine({x, axes.low.y}, {x, axes.high.y}, shown_moment_colour,
                    static_cast<float>(1.6 * w.screen.scale()));
    }
    ink.PopClipRect();
    ImGui::SetCursorScreenPos(axes.low);
    ImGui::InvisibleButton(plot.name.c_str(), {axes.high.x - axes.low.x, axes.high.y - axes.low.y});
    w.names.name("plots." + plot.name);
    navigate(w, plot, axes);
    ImGui::SetCursorScreenPos({at.x, axes.high.y + below});
    ImGui::Dummy({1, 1});
}

/// Those of the probes of the window, which were asked for last, then the others of the run.
std::vector<PlotInfo> listed_plots(const Workbench& w) {
    std::vector<PlotInfo> plots = plots_of(w.run.snapshot()->setup->scene, w.run.history()->columns());
    add_probe_plots(w.marks.probes.all(), plots);
    const auto has_probe = [](const PlotInfo& plot) {
        return std::any_of(plot.curves.begin(), plot.curves.end(),
                           [](const CurveInfo& curve) { return curve.own != nullptr; });
    };
    std::stable_partition(plots.begin(), plots.end(), has_probe);
    return plots;
}

}  // namespace

void show_plots(Workbench& w, const PanelArea& area) {
    const Panel panel("plots", area);
    if (!w.run.snapshot() || !w.run.history()) return;
    PlotsState& state = w.plots;
    state.curves.follow(w.run.history());
    const auto same = [](const HistoryColumn& a, const HistoryColumn& b) { return a.name == b.name; };
    const auto& columns = w.run.history()->columns();
    if (!std::equal(columns.begin(), columns.end(), state.columns.begin(), state.columns.end(), same)) {
        state.columns = columns;
        state.plots = listed_plots(w);
        state.time.reset();
        state.folded.clear();
        // In a low window three plots that can be read are better than four that cannot.
        const bool low = area.height < 52 * ImGui::GetFontSize();
        for (const PlotInfo& plot : state.plots)
            if (plot.folded || (low && (plot.name == "step" || plot.name == "events")))
                state.folded.insert(plot.name);
        for (const auto& [name, opened] : w.layout.plots)  // as the user had them
            opened ? static_cast<void>(state.folded.erase(name))
                   : static_cast<void>(state.folded.insert(name));
    }
    if (state.probe_changes != w.marks.probe_changes) state.plots = listed_plots(w);
    state.probe_changes = w.marks.probe_changes;
    const std::optional<double> cursor = std::exchange(state.cursor, std::nullopt);
    const auto open = [&](const PlotInfo& plot) { return !state.folded.contains(plot.name); };
    const auto opened = std::count_if(state.plots.begin(), state.plots.end(), open);
    const float em = ImGui::GetFontSize();
    const float title = ImGui::GetTextLineHeightWithSpacing() + 2;
    const float room = ImGui::GetContentRegionAvail().y - title * static_cast<float>(state.plots.size()) -
                       (ImGui::GetStyle().ItemSpacing.y + 3) * static_cast<float>(opened) - 2.5F * em;
    const float height = std::max(room / static_cast<float>(std::max<std::ptrdiff_t>(opened, 1)), 8 * em);
    const auto times = shown_times(w);
    const PlotInfo* last = nullptr;
    for (const PlotInfo& plot : state.plots)
        if (open(plot)) last = &plot;
    for (const PlotInfo& plot : state.plots)
        show_plot(w, plot, &plot == last ? height + 2 * em : height, times, &plot == last, cursor);
}

}  // namespace percuss::app
