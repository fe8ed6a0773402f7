#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/figure_spec.hpp"
#include "scene/formula.hpp"
#include "scene/lesson.hpp"
#include "scene/place.hpp"
#include "scene/study_spec.hpp"
#include "units.hpp"

/// The typed scene: what a scene file says, checked, with defaults filled in. All numbers are in scene units.
/// scenes/README.md documents each key; parse.hpp makes a Scene from text.
namespace percuss {

enum class Geometry { axisymmetric, plane_strain, plane_stress };

struct StepSize {
    std::optional<double> fixed;  ///< [time]; when absent the step is `courant` times the critical step
    double courant = 0.9;         ///< fraction of the critical step, 0 < courant <= 1
    Place place;
    bool operator==(const StepSize&) const = default;
};

struct BulkViscosity {
    double linear = 0;     ///< coefficient of rho c h |D|, dimensionless (0.06 is usual)
    double quadratic = 0;  ///< coefficient of rho h^2 D^2, dimensionless (1.2 is usual)
    bool operator==(const BulkViscosity&) const = default;
};

/// Yield stress = yield + linear ep + saturation (1 - exp(-rate ep)), ep the equivalent plastic strain
/// (linear + Voce).
struct VoceHardening {
    double yield = 0;       ///< at ep = 0 [stress]
    double linear = 0;      ///< slope of the linear part [stress]
    double saturation = 0;  ///< what the exponential part adds in the end [stress]
    double rate = 0;        ///< how fast it does so, per unit of ep, dimensionless
    bool operator==(const VoceHardening&) const = default;
};

/// Yield stress linear between points, constant after the last.
struct TabulatedHardening {
    std::vector<std::pair<double, double>>
        points;  ///< (ep, yield stress): ep rises from 0, yield stress does not fall
    bool operator==(const TabulatedHardening&) const = default;
};

/// Johnson & Cook (1983): yield stress = (A + B ep^n) (1 + C ln(rate/reference)) (1 - T*^m) with the
/// homologous temperature T* = (T - room) / (melting - room), the logarithm not below 0, and T* within 0
/// and 1. Plastic work heats the point (Taylor & Quinney): density heat_capacity dT = heat_fraction dW; no
/// heat flows.
struct JohnsonCook {
    double yield = 0;               ///< A [stress]
    double hardening = 0;           ///< B [stress]
    double exponent = 1;            ///< n
    double rate_factor = 0;         ///< C
    double reference_rate = 1;      ///< plastic strain rate up to which the rate has no effect [1/time]
    double softening_exponent = 1;  ///< m
    double room_temperature = 293;  ///< below it nothing softens [temperature]
    std::optional<double> melting_temperature;  ///< absent: no softening [temperature]
    double initial_temperature = 293;           ///< [temperature]
    std::optional<double> heat_capacity;        ///< absent: no heating [energy/(mass temperature)]
    double heat_fraction = 0.9;                 ///< of the plastic work that becomes heat
    bool operator==(const JohnsonCook&) const = default;
};

/// How a material yields; monostate: never. The order is that of PlasticLaw.
using Plasticity = std::variant<std::monostate, VoceHardening, TabulatedHardening, JohnsonCook>;

struct Material {
    std::string name;
    double density = 0;  ///< [mass/length^3]
    double young = 0;    ///< Young's modulus [stress]
    double poisson = 0;  ///< -1 < nu < 0.5
    std::optional<BulkViscosity> viscosity;
    Place place;
    Plasticity plasticity;
    bool operator==(const Material&) const = default;
};

/// Shape of a block edge between its two corners.
struct Straight {
    bool operator==(const Straight&) const = default;
};
struct Arc {
    Vec2 through;  ///< a point of the arc between the corners
    bool operator==(const Arc&) const = default;
};
struct Polyline {
    std::vector<Vec2> points;  ///< inner points, in the direction in which the edge is walked
    bool operator==(const Polyline&) const = default;
};
/// Coordinates by formulas: one as a function of the other, which runs evenly from corner to corner, or both
/// as functions of s, which runs from 0 to 1. The formulas' ends are the corners.
struct FormulaSide {
    CoordinateFormulas of;
    bool operator==(const FormulaSide&) const = default;
};
using EdgeShape = std::variant<Straight, Arc, Polyline, FormulaSide>;

enum class CellPattern { quads, diagonal, crossed };  ///< quads; 2 triangles a cell; 4 triangles a cell

/// A four-sided patch, meshed by transfinite interpolation. Sides in order bottom (corner 0 to 1),
/// right (1 to 2), top (2 to 3), left (3 to 0); the corners run counter-clockwise.
struct Block {
    std::array<Vec2, 4> corners;
    std::array<EdgeShape, 4> shapes;      ///< bottom, right, top, left; polyline points in walking direction
    std::array<int, 2> divisions{1, 1};   ///< cells along bottom/top, cells along right/left
    std::array<double, 2> grading{1, 1};  ///< last / first cell length from corner 0 to 1, from corner 0 to 3
    /// Where the cells end, from 0 to 1 along bottom/top and right/left; empty: by the grading.
    std::array<std::vector<double>, 2> fractions;
    /// Moves each node by formulas of its coordinates (r, z), of i and j (its column and row from 0), of R (r
    /// at the right end of its row) and Z (z at the top end of its column); in plane scenes x, y, X, Y.
    CoordinateFormulas shift;
    std::array<std::string, 4> edge_names;  ///< "" where the side is not named
    Place place;
    bool operator==(const Block&) const = default;
};

/// An edge made of connected edges of the body.
struct Chain {
    std::string name;
    std::vector<std::string> edges;
    bool operator==(const Chain&) const = default;
};

/// A value that may vary in time: constant, or linear between points and constant outside them.
struct TimeFunction {
    std::vector<std::pair<double, double>> points;  ///< (time, value); one point = constant
    [[nodiscard]] double operator()(double time) const;
    bool operator==(const TimeFunction&) const = default;
};

enum class Direction { first, second };  ///< r or x; z or y

struct Constraint {
    std::string edge;                          ///< named edge, or "" for the whole body
    std::array<bool, 2> fixed{false, false};   ///< directions held at zero velocity
    std::optional<std::array<double, 4>> box;  ///< only nodes inside {min0, min1, max0, max1}
    Place place;
    bool operator==(const Constraint&) const = default;
};

struct PrescribedVelocity {
    std::string edge;  ///< named edge, or "" for the whole body
    Direction direction = Direction::second;
    TimeFunction velocity;                                   ///< [velocity]
    double from = 0;                                         ///< before this time the nodes are free [time]
    double until = std::numeric_limits<double>::infinity();  ///< and from this time on [time]
    /// Whether the motion of a step is imposed. @param time of the middle of the step.
    [[nodiscard]] bool acts(double time) const { return from <= time && time < until; }
    Place place;
    bool operator==(const PrescribedVelocity&) const = default;
};

struct EdgeLoad {
    std::string edge;
    std::optional<TimeFunction> pressure;                 ///< follower, positive pushes on the body [stress]
    std::array<std::optional<TimeFunction>, 2> traction;  ///< per reference area, fixed direction [stress]
    Place place;
    bool operator==(const EdgeLoad&) const = default;
};

struct Body {
    std::string name;
    std::string material;
    ElementKind element = ElementKind::quad_one_point;
    CellPattern pattern = CellPattern::quads;
    double hourglass = 0.1;  ///< Flanagan-Belytschko stiffness coefficient; one-point quads only
    std::array<double, 2> velocity{0, 0};    ///< initial velocity
    std::array<double, 2> body_force{0, 0};  ///< acceleration by body forces, e.g. gravity [acceleration]
    std::vector<Block> blocks;
    std::vector<Chain> chains;
    std::vector<Constraint> constraints;
    std::vector<PrescribedVelocity> prescribed;
    std::vector<EdgeLoad> loads;
    Place place;
    bool operator==(const Body&) const = default;
};

/// A rigid half space that does not move; contact pairs name it as their slave.
struct Wall {
    std::string name;
    Vec2 point{0, 0};   ///< of its surface [length]
    Vec2 normal{0, 1};  ///< unit, out of the wall
    Place place;
    bool operator==(const Wall&) const = default;
};

/// One side of a contact pair: a named edge of a body, its whole outline when `edge` is empty, or a wall.
struct SurfaceName {
    std::string body;  ///< or wall
    std::string edge;
    Place place;
    bool operator==(const SurfaceName&) const = default;
};

enum class ContactScheme {
    projection,  ///< the paper's nodal projection, pair by pair in the order of the scene
    joint,       ///< one nonnegative problem for all pairs that share nodes
    penalty,     ///< springs against penetration
    bipenalty,   ///< the same with inertia, so that they do not lower the critical step
    massless,    ///< contact nodes without mass, where elements and contact forces balance
};
enum class ContactSign {
    restricted,    ///< no tensile contact force: C >= 0
    unrestricted,  ///< the paper's equations as they stand; negative C are counted
};

/// How the joint problem keeps the surfaces of a pair apart.
enum class RowScheme {
    node_to_side,        ///< master nodes out of slave sides
    symmetric,           ///< nodes of each out of sides of the other
    segment_to_segment,  ///< mean gaps of overlapping sides, with guards for nodes
};

/// What the rows of a pair in the joint problem ask of their gaps.
enum class ContactLevel {
    position,  ///< not to close further than to zero
    velocity,  ///< not to close any further once they are closed, or would be within the step
};

/// Linear bulk viscosity in the elements next to the surfaces of a pair.
struct ContactLayer {
    double viscosity = 0;  ///< coefficient of rho c h |D| in compression
    int layers = 3;        ///< of elements on either side
    bool operator==(const ContactLayer&) const = default;
};

struct ContactPair {
    std::string name;
    std::string table;  ///< name of the [[contact]] it is of; those of `bodies = "all"` share one
    SurfaceName master, slave;
    bool by_bodies =
        false;  ///< two bodies without roles: `master` is only the one that forces are counted on
    RowScheme scheme = RowScheme::node_to_side;   ///< joint only
    ContactLevel level = ContactLevel::position;  ///< joint only
    ContactSign sign = ContactSign::restricted;
    double friction = 0;  ///< Coulomb's coefficient; 0: the pair slides freely
    std::optional<ContactLayer> layer;
    Place place;
    bool operator==(const ContactPair&) const = default;
};

/// Whether the pair is a body's whole outline with itself: folds.
[[nodiscard]] inline bool is_self_contact(const ContactPair& pair) {
    return pair.by_bodies && pair.master.body == pair.slave.body;
}

/// What solves the nonnegative problem for the contact forces.
enum class ForceSolver { active_set, gauss_seidel, conjugate_gradient };

/// How the contact pairs are solved, all of them alike.
struct ContactSolver {
    ContactScheme scheme = ContactScheme::projection;
    double recovery_speed = 1;  ///< joint: a penetration is taken back no faster than this [velocity]
    ForceSolver solver = ForceSolver::active_set;  ///< joint, bipenalty
    double penalty = 0.1;           ///< penalty, bipenalty: springs as parts of the stiffness of the elements
    bool step_of_elements = false;  ///< penalty: its springs do not lower the step
    bool operator==(const ContactSolver&) const = default;
};

struct Probe {
    std::string name;
    std::string body;
    Vec2 at{0, 0};  ///< initial position; nearest cell for stress, nearest node for motion
    std::vector<std::string>
        record;  ///< e.g. "stress.axial", "von_mises", "velocity.axial", "displacement.radial"
    Place place;
    bool operator==(const Probe&) const = default;
};

struct Recording {
    int history_every = 1;         ///< steps between history rows
    std::optional<double> frames;  ///< simulated time between frames [time]; absent: duration / 100
    bool operator==(const Recording&) const = default;
};

enum class ForceScale { automatic, fixed, logarithmic };
enum class VerticalAxis { first, second };  ///< which coordinate points up in pictures

struct ViewOptions {
    std::string field = "von_mises";
    std::optional<std::array<double, 2>> range;  ///< colour range in scene units; absent: over the frame
    std::string colour_map = "viridis";
    bool edges = true;   ///< draw element edges
    bool mirror = true;  ///< axisymmetric: draw both halves
    bool forces = true;  ///< contact-force arrows
    ForceScale force_scale = ForceScale::automatic;
    std::optional<double> force_reference;  ///< force drawn as the reference arrow [force]
    /// Part of the reference force below which no arrow is drawn; absent: 0.01, logarithmic 0.001.
    std::optional<double> force_cut_off;
    bool velocities = true;  ///< arrow and label of each body's mean velocity
    VerticalAxis up = VerticalAxis::second;
    std::optional<std::array<double, 4>>
        window;                          ///< shown region {min0, min1, max0, max1}; absent: all bodies
    std::array<int, 2> size{1280, 720};  ///< pixels
    std::vector<std::string> charts;  ///< side charts: "force", "velocity", "energy", or history column names
    double frames_per_second = 25;
    bool operator==(const ViewOptions&) const = default;
};

/// A closed-form history to compare with: piecewise linear in time; jumps are two points at one time.
struct ExactHistory {
    std::string quantity;  ///< history column, e.g. "contact.impact.axial"
    std::string label;
    std::vector<std::pair<double, double>> points;  ///< (time, value)
    double window = 0;                              ///< moving-average window of the averaged error [time]
    Place place;
    bool operator==(const ExactHistory&) const = default;
};

/// A promise about summary.json: the value at `path` lies in [min, max].
struct Expectation {
    std::string path;  ///< e.g. "energy.maximum_loss", "contact.impact.open_close_events"
    double min = 0, max = 0;
    std::string why;
    Place place;
    bool operator==(const Expectation&) const = default;
};

/// A number by which a scene can be varied; other numbers are expressions of it.
struct Parameter {
    std::string name;
    double value = 0;                            ///< in `unit`, which is a label only
    std::optional<std::array<double, 2>> range;  ///< lowest and highest value allowed
    std::string unit, description;
    std::string expression;  ///< "= 2*shank" when it follows from other parameters, else ""
    Place place;
    bool operator==(const Parameter&) const = default;
};

struct Scene {
    std::string title;
    std::string description;
    std::vector<Parameter> parameters;  ///< in the order of the file
    Units units;
    Geometry geometry = Geometry::axisymmetric;
    double thickness = 1;  ///< plane scenes only [length]
    double duration = 0;   ///< [time]
    StepSize step;
    bool lagged = false;  ///< stresses at the uncorrected (penetrated) positions: the teaching mode
    double energy_growth_limit =
        0.5;  ///< run stops when the total energy exceeds (1 + limit) times the input
    std::vector<Material> materials;
    std::vector<Body> bodies;
    std::vector<Wall> walls;
    ContactSolver contact_solver;
    std::vector<ContactPair> contacts;
    std::vector<Probe> probes;
    Recording record;
    ViewOptions view;
    std::vector<FigureSpec> figures;
    Analysis analysis;
    std::vector<ExactHistory> exact;
    std::vector<Expectation> expect;
    std::optional<Lesson> lesson;
    std::optional<StudySpec> study;
    std::optional<AccuracyTarget> accuracy;

    std::string file;                    ///< path as given, for messages
    std::string text;                    ///< the file's text, as read
    std::vector<std::string> overrides;  ///< "key=value", in the order given
    std::vector<std::string> warnings;   ///< "file:line:column: warning: ..."
    bool operator==(const Scene&) const = default;
};

/// Whether a contact pair of the scene calls for friction.
[[nodiscard]] inline bool has_friction(const Scene& scene) {
    for (const ContactPair& pair : scene.contacts)
        if (pair.friction > 0) return true;
    return false;
}

}  // namespace percuss
