#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "image.hpp"
#include "live/curves.hpp"
#include "scene/figure_spec.hpp"
#include "workbench/export/writer.hpp"

namespace percuss::app {

class MomentsFilm;
class PictureStream;
class Workbench;

/// What the fields of the export panel say.
struct ExportSettings {
    std::string name;          ///< files are NAME.png, NAME.mp4, NAME-figures/, ...
    int factor = 2;            ///< of a picture's size over the viewport's
    double from = 0;           ///< of films [time]
    std::optional<double> to;  ///< absent: as far as the run has got [time]
    int count = 100;           ///< pictures of a film
    double frames_per_second = 25;
    std::array<int, 2> size{0, 0};  ///< of films [pixels]; 0: as the viewport
    std::string scene;              ///< file that the scene is saved to
    bool with_view = false;         ///< saves the picture's settings with the scene
    int to_panel = 0;               ///< frames in which the panel still is to be scrolled into sight
    bool replace = false;           ///< the next save may replace a scene that exists
};

enum class PlotFormat { csv, png };

/// What leaves the window as files. Nothing that exists is replaced: names that are taken get a number.
class Exports {
  public:
    Exports();
    ~Exports();  ///< ends what is under way; a film or recording that is not done leaves nothing

    // Commands. What cannot be done is told.
    void save_scene(Workbench& w);
    void save_picture(Workbench& w);
    void save_plot(Workbench& w, const PlotInfo& plot, PlotFormat format);
    void save_open_plots(Workbench& w, PlotFormat format);
    void begin_figures(Workbench& w);
    void begin_film(Workbench& w, bool film);  ///< else numbered pictures
    void cancel(Workbench& w);                 ///< of film or figures
    void toggle_recording(Workbench& w);       ///< of what the viewport shows as it runs

    /// Goes on with what is under way; once a frame of the window.
    void advance(Workbench& w);
    /// Whether the window's next picture is to be given to take_frame.
    [[nodiscard]] bool wants_frame(const Workbench& w) const;
    void take_frame(Workbench& w, const render::Image& window);

    [[nodiscard]] bool working() const;     ///< a film or figures
    [[nodiscard]] double progress() const;  ///< of them, 0 to 1
    [[nodiscard]] bool recording() const { return recording_ != nullptr; }
    [[nodiscard]] bool busy() const;  ///< any of it, or files are being written
    [[nodiscard]] const std::vector<std::string>& written() const {
        return written_;
    }  ///< files, oldest first
    [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }
    void dismiss_faults() { faults_.clear(); }

    ExportSettings settings;

  private:
    struct Figures;
    void fail(Workbench& w, const std::string& why);
    void tell_written(Workbench& w, const std::string& file);
    void draw_next_figure(Workbench& w);
    void follow_film(Workbench& w);
    void follow_recording(Workbench& w);
    /// NAMEsuffix, with a number where that is taken.
    [[nodiscard]] std::filesystem::path free_name(const std::string& suffix);

    std::filesystem::path file_;  // of the scene that the names are for
    std::set<std::filesystem::path> given_;
    Writer writer_;
    std::unique_ptr<MomentsFilm> film_;
    std::unique_ptr<Figures> figures_;
    std::unique_ptr<PictureStream> recording_;
    std::vector<std::unique_ptr<PictureStream>>
        ending_;                            // recordings and cancelled films that are being written
    double clock_ = 0, recording_due_ = 0;  // of the window [s]
    long long recorded_draw_ = -1;
    std::array<int, 2> recorded_size_{0, 0};
    std::vector<std::string> written_, faults_;
};

/// NAME-N.toml beside the file, with the smallest N that is free. @param given names that are taken, too.
[[nodiscard]] std::filesystem::path free_scene_name(const std::filesystem::path& scene,
                                                    const std::set<std::filesystem::path>& given);

}  // namespace percuss::app
