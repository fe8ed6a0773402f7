#include "figures/draw_run.hpp"

#include "figures/run_page.hpp"
#include "image.hpp"
#include "output.hpp"

namespace percuss::app {

std::vector<std::filesystem::path> draw_run_figures(render::Context& context, const RecordedRun& run,
                                                    const std::vector<FigureSpec>& figures,
                                                    const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::vector<std::filesystem::path> files;
    for (const FigureSpec& figure : figures) {
        const RunPage made = make_run_page(run, figure);
        const render::Image image = render::draw_page(context, made.page);
        files.push_back(folder / (figure.name + ".png"));
        write_whole(files.back(),
                    [&](const std::filesystem::path& aside) { render::write_png(image, aside); });
        if (!made.csv) continue;
        files.push_back(folder / (figure.name + ".csv"));
        write_text_file(files.back(), *made.csv);
    }
    return files;
}

std::vector<std::filesystem::path> draw_declared_figures(const std::filesystem::path& run_file,
                                                         const std::filesystem::path& folder) {
    const RecordedRun run = load_recorded_run(run_file);
    if (run.setup->scene.figures.empty() || run.history->rows() < 2) return {};
    const auto context = render::make_offscreen_context();
    return draw_run_figures(*context, run, run.setup->scene.figures, folder);
}

}  // namespace percuss::app
