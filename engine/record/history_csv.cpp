#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "record/csv_cell.hpp"
#include "record/run_file.hpp"

namespace percuss {
void write_history_csv(const std::filesystem::path& file, const History& history, const Units& units,
                       int every) {
    std::ofstream out(file, std::ios::binary);
    fmt::memory_buffer text;
    for (const HistoryColumn& column : history.columns()) {
        const std::string label = units.label(column.quantity);
        const std::string header = label.empty() ? column.name : fmt::format("{} [{}]", column.name, label);
        fmt::format_to(std::back_inserter(text), "{}{}", text.size() > 0 ? "," : "", csv_cell(header));
    }
    text.push_back('\n');
    const std::size_t rows = history.rows(), width = history.columns().size();
    const auto stride = static_cast<std::size_t>(std::max(every, 1));
    for (std::size_t i = 0; i < rows; i += stride) {
        const std::vector<double> row = history.table(i, i + 1);
        for (std::size_t c = 0; c < width; ++c) {
            fmt::format_to(std::back_inserter(text), "{}{:.17g}", c > 0 ? "," : "", row[c]);
        }
        text.push_back('\n');
        if (text.size() > 1 << 20) {
            out.write(text.data(), static_cast<std::streamsize>(text.size()));
            text.clear();
        }
    }
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) throw RecordError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace percuss
