#include "view/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <GL/glew.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

namespace percuss::render {

namespace {

vtkSmartPointer<vtkCellArray> make_polygons(const Mesh& mesh) {
    auto polygons = vtkSmartPointer<vtkCellArray>::New();
    polygons->AllocateEstimate(mesh.cell_count(), 4);
    for (const Cell& cell : mesh.cells) {
        vtkIdType corners[4];
        std::copy(cell.begin(), cell.end(), corners);
        polygons->InsertNextCell(corner_count(cell), corners);
    }
    return polygons;
}

/// The boundary of the bodies, but not where mirror images meet.
vtkSmartPointer<vtkCellArray> make_outlines(const Mesh& mesh, bool mirrored) {
    auto lines = vtkSmartPointer<vtkCellArray>::New();
    const auto on_axis = [&](std::int32_t node) {
        return mesh.nodes[static_cast<std::size_t>(node)][0] <= 0;
    };
    for (const MeshBody& body : mesh.bodies)
        for (const Edge& edge : body.outlines)
            for (std::size_t i = 0; i + (edge.closed ? 0 : 1) < edge.nodes.size(); ++i) {
                const std::int32_t a = edge.nodes[i], b = edge.nodes[(i + 1) % edge.nodes.size()];
                if (!(mirrored && on_axis(a) && on_axis(b))) lines->InsertNextCell({a, b});
            }
    return lines;
}

/// Every element edge once: an edge shared by two elements and drawn twice would look darker than the
/// outline.
vtkSmartPointer<vtkCellArray> make_edges(const Mesh& mesh) {
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    for (const Cell& cell : mesh.cells) {
        const auto corners = static_cast<std::size_t>(corner_count(cell));
        for (std::size_t i = 0; i < corners; ++i)
            edges.push_back(std::minmax({cell[i], cell[(i + 1) % corners]}));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    auto lines = vtkSmartPointer<vtkCellArray>::New();
    lines->AllocateEstimate(static_cast<vtkIdType>(edges.size()), 2);
    for (const auto& [a, b] : edges) lines->InsertNextCell({a, b});
    return lines;
}

/// An actor painted over what is there: all parts lie in one plane, and the soft rims of smooth lines would
/// else hide each other where lines meet.
class FlatActor : public vtkOpenGLActor {
  public:
    static FlatActor* New();
    vtkTypeMacro(FlatActor, vtkOpenGLActor) void Render(vtkRenderer* renderer, vtkMapper* mapper) override {
        vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
        state->vtkglDepthFunc(GL_ALWAYS);
        vtkOpenGLActor::Render(renderer, mapper);
        state->vtkglDepthFunc(GL_LEQUAL);
    }

  protected:
    FlatActor() = default;

  private:
    FlatActor(const FlatActor&) = delete;
    FlatActor& operator=(const FlatActor&) = delete;
};
vtkStandardNewMacro(FlatActor)

    void set_values(vtkFloatArray& array, const std::vector<double>& values) {
    array.SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::transform(values.begin(), values.end(), array.GetPointer(0),
                   [](double value) { return static_cast<float>(value); });
    array.Modified();
}

}  // namespace

double mean_cell_size(const Mesh& mesh) {
    double area = 0;
    for (const Cell& cell : mesh.cells) {
        const auto corner = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(cell[k])]; };
        const auto last = static_cast<std::size_t>(corner_count(cell) - 1);
        const Vec2 a = corner(last == 3 ? 2 : 1) - corner(0), b = corner(last) - corner(last == 3 ? 1 : 0);
        area += 0.5 * std::abs(a[0] * b[1] - a[1] * b[0]);  // half the product of the diagonals
    }
    return std::sqrt(area / std::max(1, mesh.cell_count()));
}

double edge_opacity(double cell_size) { return std::clamp((cell_size - 1.5) / 10, 0.0, 0.55); }

Surface::Surface(const Mesh& mesh, const Plane& plane, vtkRenderer& renderer)
    : plane_(plane), renderer_(renderer) {
    points_ = vtkSmartPointer<vtkPoints>::New();
    points_->SetDataTypeToFloat();
    points_->SetNumberOfPoints(mesh.node_count());
    cells_ = vtkSmartPointer<vtkPolyData>::New();
    cells_->SetPoints(points_);
    cells_->SetPolys(make_polygons(mesh));
    lines_ = vtkSmartPointer<vtkPolyData>::New();
    lines_->SetPoints(points_);
    lines_->SetLines(make_edges(mesh));
    outlines_ = vtkSmartPointer<vtkPolyData>::New();
    outlines_->SetPoints(points_);
    outlines_->SetLines(make_outlines(mesh, plane.mirrored));
    cell_values_ = vtkSmartPointer<vtkFloatArray>::New();
    node_values_ = vtkSmartPointer<vtkFloatArray>::New();

    cell_mapper_ = vtkSmartPointer<vtkPolyDataMapper>::New();
    cell_mapper_->SetInputData(cells_);
    cell_mapper_->InterpolateScalarsBeforeMappingOn();
    cell_mapper_->UseLookupTableScalarRangeOff();
    line_mapper_ = vtkSmartPointer<vtkPolyDataMapper>::New();
    line_mapper_->SetInputData(lines_);
    line_mapper_->ScalarVisibilityOff();
    outline_mapper_ = vtkSmartPointer<vtkPolyDataMapper>::New();
    outline_mapper_->SetInputData(outlines_);
    outline_mapper_->ScalarVisibilityOff();
    add_actors(cell_mapper_, cell_actors_);
    add_actors(line_mapper_, line_actors_);
    add_actors(outline_mapper_, outline_actors_);
    set_edges(true, 0.5);
}

Surface::~Surface() {
    for (const auto* actors : {&cell_actors_, &line_actors_, &outline_actors_})
        for (const auto& actor : *actors) renderer_.RemoveActor(actor);
}

void Surface::add_actors(vtkPolyDataMapper* mapper, std::vector<vtkSmartPointer<vtkActor>>& actors) {
    for (int half = 0; half < (plane_.mirrored ? 2 : 1); ++half) {
        auto actor = vtkSmartPointer<FlatActor>::New();
        actor->SetMapper(mapper);
        actor->GetProperty()->LightingOff();
        actor->GetProperty()->SetColor(0.10, 0.12, 0.15);  // of lines; cells take their scalars' colours
        actor->ForceOpaqueOn();  // faint lines are blended all the same, without the cost of a translucent
                                 // pass
        double scale[3] = {1, 1, 1};
        if (half == 1) scale[plane_.mirror_axis()] = -1;
        actor->SetScale(scale);
        renderer_.AddActor(actor);
        actors.push_back(std::move(actor));
    }
}

void Surface::update(const std::vector<double>& position, const std::vector<double>& values, bool per_cell) {
    for (vtkIdType i = 0; i < points_->GetNumberOfPoints(); ++i) {
        const auto at = 2 * static_cast<std::size_t>(i);
        const auto [right, upward] = plane_(position[at], position[at + 1]);
        points_->SetPoint(i, right, upward, 0);
    }
    points_->Modified();
    if (per_cell) {
        set_values(*cell_values_, values);
        cells_->GetCellData()->SetScalars(cell_values_);
        cells_->GetPointData()->SetScalars(nullptr);
        cell_mapper_->SetScalarModeToUseCellData();
    } else {
        set_values(*node_values_, values);
        cells_->GetPointData()->SetScalars(node_values_);
        cells_->GetCellData()->SetScalars(nullptr);
        cell_mapper_->SetScalarModeToUsePointData();
    }
}

void Surface::set_colours(vtkLookupTable* table, const std::array<double, 2>& range) {
    cell_mapper_->SetLookupTable(table);
    cell_mapper_->SetScalarRange(range[0], range[1]);
}

void Surface::set_edges(bool shown, double opacity) {
    edges_ = shown;
    show(line_actors_, edges_);
    for (const auto& actor : line_actors_) actor->GetProperty()->SetOpacity(opacity);
}

void Surface::set_halves(bool meshed, bool mirror_image) {
    halves_ = {meshed, mirror_image};
    show(cell_actors_, true);
    show(line_actors_, edges_);
    show(outline_actors_, true);
}

void Surface::show(const std::vector<vtkSmartPointer<vtkActor>>& actors, bool shown) {
    for (std::size_t half = 0; half < actors.size(); ++half)
        actors[half]->SetVisibility(shown && halves_[half]);
}

void Surface::set_line_widths(double edges, double outlines) {
    for (const auto& actor : line_actors_) actor->GetProperty()->SetLineWidth(static_cast<float>(edges));
    for (const auto& actor : outline_actors_)
        actor->GetProperty()->SetLineWidth(static_cast<float>(outlines));
}

}  // namespace percuss::render
