#include "workbench/thumbnails/thumbnails.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "figures/page.hpp"
#include "mesh/build.hpp"
#include "output.hpp"
#include "run/state_hash.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view style = "percuss thumbnail 1";  // another look needs another number

std::shared_ptr<const Snapshot> beginning_of(Scene scene) {
    Mesh mesh = build_mesh(scene);
    auto snapshot = std::make_shared<Snapshot>();
    for (const Vec2& node : mesh.nodes)
        snapshot->position.insert(snapshot->position.end(), {node[0], node[1]});
    snapshot->velocity.resize(snapshot->position.size());
    snapshot->stress.resize(mesh.cells.size());
    snapshot->bodies.resize(scene.bodies.size());
    snapshot->pairs.resize(scene.contacts.size());
    snapshot->setup = std::make_shared<const RunSetup>(RunSetup{std::move(scene), std::move(mesh)});
    return snapshot;
}

render::Image draw(render::Context& context, std::shared_ptr<const Snapshot> beginning) {
    render::MeshPicture picture;
    picture.options = beginning->setup->scene.view;
    picture.options.edges = false;
    picture.snapshot = std::move(beginning);
    render::Page page;
    page.width = Thumbnails::width;
    page.height = Thumbnails::height;
    page.type = 0.4;
    page.panels.push_back({std::move(picture), {0, 0, 1, 1}});
    return render::draw_page(context, page);
}

}  // namespace

Thumbnails::~Thumbnails() = default;

Thumbnails::Read Thumbnails::read(const std::string& scene, const std::optional<fs::path>& folder) {
    Read result;
    result.scene = scene;
    if (fs::path(scene).extension() == ".h5") {
        result.title = "recorded run";
        return result;
    }
    try {
        Scene parsed = load_scene(scene);
        result.title = parsed.title;
        if (folder) {
            const auto hash =
                hash_bytes(parsed.text.data(), parsed.text.size(), hash_bytes(style.data(), style.size()));
            result.cached = *folder / (hash_text(hash) + ".png");
            if (fs::exists(result.cached)) {
                try {
                    result.image = render::read_png(result.cached);
                    if (result.image->width == width && result.image->height == height) return result;
                } catch (const render::RenderError&) {
                }
                result.image.reset();  // spoilt: drawn anew
            }
        }
        result.beginning = beginning_of(std::move(parsed));
    } catch (const SceneError& error) {
        result.fault = error.messages().empty() ? error.what() : error.messages().front();
    } catch (const std::exception& error) {
        result.fault = error.what();
    }
    return result;
}

void Thumbnails::want(const std::vector<std::string>& scenes) {
    cards_.clear();  // files may have changed; what is on disk comes back at once
    wanted_.assign(scenes.rbegin(), scenes.rend());
}

void Thumbnails::advance(render::Context& context) {
    static_cast<void>(worker_.take_results());  // a picture that cannot be kept is drawn again next time
    std::optional<Read> result;
    {
        const std::lock_guard lock(mutex_);
        result = std::exchange(result_, std::nullopt);
    }
    if (result) {
        under_way_ = false;
        SceneCard card{std::move(result->title), std::move(result->fault), nullptr};
        try {
            if (result->beginning) {
                result->image = draw(context, std::move(result->beginning));
                ++drawn_;
                if (!result->cached.empty())
                    worker_.post([file = result->cached, image = *result->image] {
                        fs::create_directories(file.parent_path());
                        write_whole(file, [&](const fs::path& aside) { render::write_png(image, aside); });
                        return std::string();
                    });
            }
            if (result->image) card.picture = std::make_unique<render::Texture>(context, *result->image);
        } catch (const std::exception& error) {
            card.fault = error.what();
        }
        cards_[result->scene] = std::move(card);
    }
    if (under_way_ || wanted_.empty()) return;
    under_way_ = true;
    worker_.post([this, scene = wanted_.back(), folder = folder_] {
        Read read_now = read(scene, folder);
        const std::lock_guard lock(mutex_);
        result_ = std::move(read_now);
        return std::string();
    });
    wanted_.pop_back();
}

const SceneCard* Thumbnails::find(const std::string& scene) const {
    const auto found = cards_.find(scene);
    return found == cards_.end() ? nullptr : &found->second;
}

}  // namespace percuss::app
