#include "study/study_page.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "image.hpp"
#include "study/study_table.hpp"

namespace percuss::app {
namespace {

constexpr const char* style = R"(body { font: 16px/1.45 system-ui, "DejaVu Sans", sans-serif; color: #1f2630;
  max-width: 76em; margin: 2em auto; padding: 0 1.2em; }
h1 { font-size: 1.6em; margin-bottom: 0.2em; } h2 { font-size: 1.2em; margin-top: 2em; }
p.scene { color: #5b6673; margin-top: 0; } ul.said { padding-left: 1.2em; } ul.said li { margin: 0.35em 0; }
ul.said li:first-child { font-weight: 600; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 0.86em; }
th, td { padding: 0.28em 0.55em; text-align: right; border-bottom: 1px solid #e7eaed; white-space: nowrap; }
th { border-bottom: 1px solid #5b6673; vertical-align: bottom; white-space: normal; } td.left, th.left { text-align: left; }
td.best { background: #e3f1ea; } td.bad { color: #a33a00; } td.text { white-space: normal; text-align: left; }
figure { margin: 1em 0 1.6em; } figure img { width: 100%; border: 1px solid #e7eaed; }
figcaption, p.note { color: #5b6673; font-size: 0.86em; }
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\n':
                result += "<br>";
                break;
            default:
                result += c;
        }
    return result;
}

/// A table of texts. @param left columns to the left. @param mark class of a cell below the header.
template <class Mark>
std::string table(const std::vector<std::vector<std::string>>& rows, std::size_t left, Mark mark) {
    std::string html = "<div class=\"wide\"><table>\n";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        html += "<tr>";
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            std::string classes = c < left ? "left" : "";
            if (const std::string more = r > 0 ? mark(r - 1, c) : ""; !more.empty())
                classes += (classes.empty() ? "" : " ") + more;
            const char* cell = r == 0 ? "th" : "td";
            html += fmt::format("<{}{}>{}</{}>", cell,
                                classes.empty() ? "" : fmt::format(" class=\"{}\"", classes),
                                escaped(rows[r][c]), cell);
        }
        html += "</tr>\n";
    }
    return html + "</table></div>\n";
}

std::string cases_table(const Study& study, const std::vector<CaseResult>& results,
                        const Evaluation& evaluation) {
    const std::size_t axes = study.axes.size();
    std::vector<std::set<std::size_t>> best(study.quantities.size());
    for (const Design& design : evaluation.designs)
        for (std::size_t q = 0; q < design.fronts.size(); ++q)
            best[q].insert(design.fronts[q].begin(), design.fronts[q].end());
    return table(study_rows(study, results, evaluation), axes, [&](std::size_t i, std::size_t c) {
        if (c < axes || c >= axes + best.size()) return "";
        if (results[i].state != CaseState::finished) return "bad";
        return best[c - axes].contains(i) ? "best" : "";
    });
}

std::string troubles(const Study& study, const std::vector<CaseResult>& results) {
    std::string list;
    for (std::size_t i = 0; i < results.size(); ++i)
        if (const std::string what = trouble(results[i]); !what.empty())
            list += fmt::format("<li>{}: {}</li>\n", escaped(study.cases[i].label), escaped(what));
    return list.empty() ? "" : "<h2>Cases that did not finish</h2>\n<ul>\n" + list + "</ul>\n";
}

std::string how_measured(const Study& study, const std::vector<CaseResult>& results,
                         const StudyCircumstances& circumstances) {
    double spread = 0, least_share = 1;
    for (const CaseResult& result : results) {
        spread = std::max(spread, result.spread().value_or(0));
        if (!result.seconds.empty()) least_share = std::min(least_share, result.core_share);
    }
    std::string text = fmt::format(
        "<h2>How it was measured</h2>\n<p class=\"note\">{}; {}. Times are of stepping alone, the fastest of "
        "{} "
        "in one thread; spread is what the slowest took more, at most {}. Others left each case at least {} "
        "of its core. Memory is the largest resident set of the whole process. ",
        escaped(circumstances.executor), escaped(circumstances.machine),
        study.repeat > 0 ? fmt::format("{} runs", study.repeat)
                         : "3 to 20 runs, of one when it takes more than 2 s,",
        percent(spread), percent(std::min(least_share, 1.0)));
    text +=
        "Errors are relative to the reference. Without an exact answer it is Richardson's extrapolation from "
        "the three "
        "finest levels, f<sub>1</sub> + (f<sub>1</sub> &minus; f<sub>2</sub>)/(r<sup>p</sup> &minus; 1), "
        "where the order p "
        "can be observed, with the uncertainty 1.25 |f<sub>1</sub> &minus; f<sub>2</sub>|/(r<sup>p</sup> "
        "&minus; 1), the grid "
        "convergence index (P. J. Roache, J. Fluids Eng. 116 (1994) 405), p at most 2; else the finest "
        "value, with three "
        "times the range of the levels over their number less one (L. E&ccedil;a, M. Hoekstra, J. Comput. "
        "Phys. 262 (2014) "
        "104). Histories are compared as running means, in L2. Green cells lie on the Pareto front: no other "
        "case is both "
        "cheaper and nearer.</p>\n";
    return text + fmt::format("<p class=\"note\">{}</p>\n", escaped(circumstances.command));
}

}  // namespace

std::string study_page(const Study& study, const std::vector<CaseResult>& results,
                       const Evaluation& evaluation, const std::vector<StudyFigure>& figures,
                       const std::vector<std::filesystem::path>& pictures,
                       const StudyCircumstances& circumstances) {
    const std::string title = study.scene.title.empty() ? study.scene.file : study.scene.title;
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}: a study</title>\n"
        "<style>{1}</style>\n</head>\n<body>\n<h1>{0}: what accuracy costs</h1>\n<p class=\"scene\">{2}, {3} "
        "cases</p>\n",
        escaped(title), style, escaped(study.scene.file), study.cases.size());
    html += "<ul class=\"said\">\n";
    for (const std::string& sentence : conclusions(study, results, evaluation))
        html += "<li>" + escaped(sentence) + "</li>\n";
    html += "</ul>\n<h2>The cheapest setting that is accurate enough</h2>\n";
    const std::size_t left = evaluation.designs.size() > 1 ? 2 : 1;
    html += table(cheapest_rows(study, results, evaluation), left, [&](std::size_t, std::size_t c) {
        return c == left + 1 || c == left + 2 || c == left + 4 ? "text" : "";
    });
    for (std::size_t f = 0; f < figures.size(); ++f)
        html += fmt::format(
            "<figure><img alt=\"{}\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
            escaped(figures[f].page.title), render::base64_of(pictures[f]), escaped(figures[f].caption));
    if (const auto orders = order_rows(study, evaluation); orders.size() > 1)
        html += "<h2>Observed orders</h2>\n" + table(orders, 2, [](std::size_t, std::size_t) { return ""; }) +
                "<p class=\"note\">From the two finest levels where there is an exact answer, else from "
                "three; no "
                "number where they do not converge monotonously.</p>\n";
    html += "<h2>All cases</h2>\n<p class=\"note\">Below the name of a quantity stands its error.</p>\n" +
            cases_table(study, results, evaluation);
    html += troubles(study, results) + how_measured(study, results, circumstances);
    return html + "</body>\n</html>\n";
}

}  // namespace percuss::app
