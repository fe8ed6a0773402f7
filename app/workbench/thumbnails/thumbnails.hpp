#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "image.hpp"
#include "run/snapshot.hpp"
#include "ui/texture.hpp"
#include "workbench/export/writer.hpp"

namespace percuss::app {

/// What the scene picker shows of a scene.
struct SceneCard {
    std::string title;                         ///< of the scene; "" when it cannot be used
    std::string fault;                         ///< why not, its first line
    std::unique_ptr<render::Texture> picture;  ///< null when there is none (yet)
};

/// Small pictures of scenes at time 0. Scenes are read and meshed one after another on a thread of their own,
/// drawn one a frame of the window, and kept on disk by the contents of their files.
class Thumbnails {
  public:
    static constexpr int width = 288, height = 180;  ///< [pixels]

    ~Thumbnails();
    /// Where pictures are kept from now on; nothing: nowhere.
    void keep_in(std::optional<std::filesystem::path> folder) { folder_ = std::move(folder); }
    /// Cards of these scenes, in this order; those of files that were read before are kept.
    void want(const std::vector<std::string>& scenes);
    /// Takes what was read and draws at most one picture; call once a frame while cards are shown.
    void advance(render::Context& context);
    [[nodiscard]] bool busy() const { return under_way_ || !wanted_.empty(); }
    /// Null while the scene has not been read.
    [[nodiscard]] const SceneCard* find(const std::string& scene) const;
    [[nodiscard]] int drawn() const { return drawn_; }  ///< pictures so far that were not on disk

  private:
    struct Read {
        std::string scene, title, fault;
        std::filesystem::path cached;               ///< where its picture belongs; "" when nowhere
        std::optional<render::Image> image;         ///< as found there
        std::shared_ptr<const Snapshot> beginning;  ///< to be drawn, when it was not
    };
    [[nodiscard]] static Read read(const std::string& scene,
                                   const std::optional<std::filesystem::path>& folder);

    std::optional<std::filesystem::path> folder_;
    std::vector<std::string> wanted_;  // last one first
    std::map<std::string, SceneCard> cards_;
    int drawn_ = 0;
    bool under_way_ = false;
    std::mutex mutex_;  // guards result_
    std::optional<Read> result_;
    Writer worker_;  // last: ends before what it fills
};

}  // namespace percuss::app
