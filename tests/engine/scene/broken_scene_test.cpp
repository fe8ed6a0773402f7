#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"

namespace percuss::testing {
namespace {

struct Broken {
    std::string old, replacement, message;  // message without "scene.toml:"
};

void PrintTo(const Broken& broken, std::ostream* stream) {
    *stream << broken.old << " -> " << broken.replacement;
}

class BrokenScene : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenScene, GivesItsMessage) {
    const auto& [old, replacement, message] = GetParam();
    EXPECT_EQ(faults_of(changed(small_scene, old, replacement)), "scene.toml:" + message);
}

TEST(SmallScene, IsGood) { EXPECT_EQ(faults_of(small_scene), ""); }

const std::string young = "young = 210", divisions = "divisions = [4, 8]", field = "field = \"von_mises\"";
const std::string rod = "corners = [[0, 0], [4, 0], [4, 8], [0, 8]]", fixed = "fixed = [\"axial\"]";
const std::string hammer = "corners = [[0, -2], [4, -2], [4, 0], [0, 0]]", slave = "slave = \"hammer.top\"";
const std::string record = "record = [\"stress.axial\"]";

INSTANTIATE_TEST_SUITE_P(
    Notation, BrokenScene,
    ::testing::Values(
        Broken{young, "young = = 210",
               "14:9: not TOML: Error while parsing value: could not determine value type; see "
               "https://toml.io for the notation"},
        Broken{young, "young = 210\nyoung = 211",
               "15:9: not TOML: Error while parsing key-value pair: cannot redefine existing integer "
               "'young'; see https://toml.io for the notation"},
        Broken{young, "ϣoung = 210",
               "14:1: a character beyond ASCII outside quotes; write it inside \"...\""},
        Broken{young, "yuong = 210",
               "11:1: [[material]] 'steel' lacks 'young'; add young = NUMBER in GPa\nscene.toml:14:1: "
               "unknown key 'yuong' in [[material]] 'steel'; did you mean 'young'?"},
        Broken{
            "percuss = 1", "",
            "1:1: the scene lacks 'percuss'; add percuss = 1 as the first line: the version of the format"},
        Broken{"percuss = 1", "percuss = 2",
               "1:11: version 2 of the scene format is unknown; this program reads version 1"},
        Broken{"[view]", "[veiw]", "42:2: unknown key 'veiw' in the scene; did you mean 'view'?"},
        Broken{"[[probe]]", "[probe]", "37:1: 'probe' is a table; it must be tables [[probe]]"}));

INSTANTIATE_TEST_SUITE_P(
    Values, BrokenScene,
    ::testing::Values(
        Broken{young, "young = \"210\"", "14:9: 'young' is a string; it must be a number"},
        Broken{young, "", "11:1: [[material]] 'steel' lacks 'young'; add young = NUMBER in GPa"},
        Broken{young, "young = -210", "14:9: 'young' is -210; it must be > 0"},
        Broken{young, "young = inf", "14:9: 'young' is inf; it must be a finite number"},
        Broken{young, "young = nan", "14:9: 'young' is nan; it must be a finite number"},
        Broken{"poisson = 0.3", "poisson = 0.5", "15:11: 'poisson' is 0.5; it must be > -1 and < 0.5"},
        Broken{"courant = 0.5", "courant = 1.5", "10:11: 'courant' is 1.5; it must be > 0 and <= 1"},
        Broken{"courant = 0.5", "courant = 0.5\nfixed = 1e-4",
               "10:11: 'courant' and 'fixed' exclude each other; keep one"},
        Broken{"duration = 0.1", "duration = 0", "8:12: 'duration' is 0; it must be > 0"},
        Broken{"duration = 0.1", "", "6:1: [model] lacks 'duration'; add duration = TIME in ms"},
        Broken{"duration = 0.1", "duration = 0.1\nthickness = 1",
               "9:13: 'thickness' has no meaning in an axisymmetric scene; leave it out"},
        Broken{"\"axisymmetric\"", "\"axisymetric\"",
               "7:12: unknown geometry 'axisymetric'; did you mean 'axisymmetric'?"},
        Broken{"length = \"mm\"", "length = \"mmm\"",
               "3:10: unknown unit of length 'mmm'; did you mean 'mm'?"},
        Broken{"velocity = [0, 10]", "velocity = [0, 10, 0]",
               "19:12: 'velocity' is an array of 3; it must be an array of 2 numbers"},
        Broken{"velocity = [0, 10]", "velocity = [0, \"10\"]",
               "19:16: 'velocity[1]' is a string; it must be a number"},
        Broken{"velocity = [0, 10]", "pattern = \"crossed\"",
               "19:11: 'pattern' belongs to triangles; leave it out or write element = \"triangle\""},
        Broken{"name = \"rod\"", "name = \"long rod\"",
               "24:8: 'long rod' is not a name; use letters, digits, '_' and '-' only\nscene.toml:35:10: "
               "unknown body 'rod'; valid: hammer, long rod\nscene.toml:39:8: unknown body 'rod'; valid: "
               "hammer, long rod"},
        Broken{divisions, "divisions = [4, 0]", "28:17: 'divisions[1]' is 0; it must be >= 1 and <= 1000000"},
        Broken{divisions, "divisions = [4, 8.5]", "28:17: 'divisions[1]' is 8.5; it must be an integer"},
        Broken{divisions, "divisions = [10000, 10000]",
               "28:13: the divisions make 1e+08 cells up to here; at most 5e+06 are allowed"}));

INSTANTIATE_TEST_SUITE_P(
    Names, BrokenScene,
    ::testing::Values(
        Broken{"material = \"steel\"", "material = \"stel\"",
               "18:12: unknown material 'stel'; did you mean 'steel'?"},
        Broken{
            "name = \"rod\"", "name = \"hammer\"",
            "24:8: the name 'hammer' is taken by line 16; give each its own name\nscene.toml:35:10: unknown "
            "body 'rod'; valid: hammer, hammer\nscene.toml:39:8: unknown body 'rod'; valid: hammer, hammer"},
        Broken{slave, "slave = \"hamer.top\"", "36:9: unknown body 'hamer'; did you mean 'hammer'?"},
        Broken{slave, "slave = \"hammer.topp\"",
               "36:9: body 'hammer' has no edge 'topp'; did you mean 'top'?"},
        Broken{slave, "slave = \"rod\"",
               "36:9: body 'rod' is paired with itself; name another body, or write self = true"},
        Broken{slave, "slave = \"rod.face\"\nself = true",
               "36:9: contact of a body with itself needs two different edges; name them as BODY.EDGE"},
        Broken{slave, slave + "\nself = true",
               "37:8: 'self' is true, but master and slave are different bodies; leave it out"},
        Broken{slave, slave + "\nsign = \"free\"",
               "37:8: unknown sign 'free'; valid: restricted, unrestricted"},
        Broken{"[view]", "[contact_solver]\nscheme = \"jiont\"\n[view]",
               "43:10: unknown contact scheme 'jiont'; did you mean 'joint'?"},
        Broken{"[view]", "[contact_solver]\nrecovery_speed = 1\n[view]",
               "43:18: 'recovery_speed' belongs to scheme = \"joint\" or \"massless\"; leave it out or "
               "choose that scheme"},
        Broken{"[view]", "[contact_solver]\nscheme = \"joint\"\nrecovery_speed = 0\n[view]",
               "44:18: 'recovery_speed' is 0; it must be > 0"},
        Broken{"[[contact]]", "[contact_solver]\nscheme = \"joint\"\n[[contact]]\nsign = \"unrestricted\"",
               "36:8: only the scheme \"projection\" knows tension; leave 'sign' out, or choose scheme = "
               "\"projection\" in "
               "[contact_solver]"},
        Broken{slave, slave + "\nfriction = 0.2",
               "37:12: the scheme \"projection\" knows no friction; write scheme = \"joint\" in "
               "[contact_solver], or leave 'friction' out"},
        Broken{slave, slave + "\nfriction = -0.2", "37:12: 'friction' is -0.2; it must be >= 0"},
        Broken{"edge = \"top\"", "edge = \"bottom\"",
               "31:8: body 'rod' has no edge 'bottom'; valid: face, right, top, left"},
        Broken{fixed, "fixed = [\"x\"]", "32:9: unknown direction 'x'; valid: radial, axial"},
        Broken{record, "record = [\"stress.axail\"]",
               "41:10: unknown quantity 'stress.axail'; did you mean 'stress.axial'?"},
        Broken{field, "field = \"von_mieses\"",
               "43:9: unknown field 'von_mieses'; did you mean 'von_mises'?"},
        Broken{"\"viridis\"", "\"virids\"", "44:14: unknown colour map 'virids'; did you mean 'viridis'?"},
        Broken{field, "charts = [\"contact.hti.axial\"]",
               "43:10: unknown contact 'hti' in 'contact.hti.axial'; did you mean 'hit'?"},
        Broken{field, "force_scale = \"fixed\"",
               "43:15: a fixed force scale needs its reference; add force_reference = FORCE"},
        Broken{"[view]", "[expect]\nsteps = { value = 1, min = 0 }\n[view]",
               "43:9: 'steps' must be promised as {value = .., tolerance = ..} or as {min = .., max = ..}"}));

INSTANTIATE_TEST_SUITE_P(
    Meshes, BrokenScene,
    ::testing::Values(
        Broken{rod, "corners = [[0, 0], [0, 8], [4, 8], [4, 0]]",
               "27:11: body 'rod': all cells are inverted; list the corners counter-clockwise"},
        Broken{rod, "corners = [[0, 0], [4, 0], [0, 8], [4, 8]]",
               "27:11: body 'rod': 20 of 32 cells are degenerate or inverted, the first in column 1, row 4 "
               "at (1.8125, 3.5) mm; move the corners and sides so that every cell is convex"},
        Broken{rod, "corners = [[0, 0], [4, 0], [4, 0], [0, 8]]",
               "27:11: body 'rod': 8 of 32 cells are degenerate or inverted, the first in column 4, row 1 at "
               "(3.5, 0.0625) mm; move the corners and sides so that every cell is convex"},
        Broken{
            rod, "corners = [[-1, 0], [4, 0], [4, 8], [-1, 8]]",
            "27:11: body 'rod': the mesh reaches r = -1 mm; an axisymmetric scene needs r >= 0 everywhere"},
        Broken{rod, rod + "\nedges = { top = { arc = [2, 8] } }",
               "27:11: body 'rod': the point of the arc lies on the line of its ends; move it or write "
               "\"straight\""},
        Broken{hammer, "corners = [[0, -2], [4, -2], [4, 0.25], [0, 0.25]]",
               "33:1: contact 'hit': body 'rod' overlaps body 'hammer' by 0.25 mm at (0, 0) mm; move them "
               "apart until they touch or leave a gap"},
        Broken{"at = [1, 2]", "at = [7, 2]",
               "37:1: probe 'p' at (7, 2) mm lies 3 mm outside body 'rod'; move it inside"},
        Broken{fixed, fixed + "\nbox = [5, 0, 6, 1]",
               "30:1: body 'rod': the constraint holds no node; enlarge its box"},
        Broken{slave, "slave = \"rod.right\"\nself = true",
               "33:1: contact 'hit': edges 'face' and 'right' share the node at (4, 0) mm; contact of a body "
               "with itself needs edges without common nodes"},
        Broken{"[[body.block]]\n" + hammer + "\ndivisions = [4, 2]", "block = []",
               "20:9: the mesh of body 'hammer' is empty; add a [[body.block]]\nscene.toml:34:9: body "
               "'hammer' has no edge 'top'; there are none"}));

TEST(BrokenScene, WithoutBodiesIsEmpty) {
    const auto text = small_scene.substr(0, small_scene.find("[[body]]"));
    EXPECT_EQ(faults_of(text),
              "scene.toml:1:1: the scene lacks 'body'; add [[body]] with name, material and [[body.block]]");
    Scene scene;
    EXPECT_THROW(static_cast<void>(build_mesh(scene)), SceneError);
}

TEST(BrokenScene, ThatCannotBeReadSaysSo) {
    const std::string file = "/no/such/scene.toml";
    try {
        static_cast<void>(load_scene(file));
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.what(), file + ": cannot be read; name a scene file, e.g. scenes/rods.toml");
    }
}

TEST(BrokenScene, TellsAllIndependentFaultsInTheOrderOfTheFile) {
    auto text = changed(small_scene, "duration = 0.1", "duration = -1");
    text = changed(text, field, "field = 3");
    text = changed(text, young, "young = 0");
    EXPECT_EQ(faults_of(text),
              "scene.toml:8:12: 'duration' is -1; it must be > 0\n"
              "scene.toml:14:9: 'young' is 0; it must be > 0\n"
              "scene.toml:43:9: 'field' is an integer; it must be a string");
}

TEST(BrokenScene, TooDeepOrTooLargeIsRefusedBeforeTheParser) {
    std::string deep = "a";
    for (int i = 0; i < 100'000; ++i) deep += ".a";
    EXPECT_EQ(faults_of(small_scene + deep + " = 1\n"),
              "scene.toml:45:130: a key of more than 64 dots; the deepest key has 5 parts");
    EXPECT_EQ(faults_of("x = " + std::string(100'000, '[')).find("scene.toml:1:"), 0U);
    EXPECT_EQ(faults_of("# " + std::string(9'000'000, '.')),
              "scene.toml:1:1: the scene has 9000002 bytes; at most 8000000 are read");
    EXPECT_EQ(faults_of("# " + std::string(1000, '.') + "\ntitle = \"" + std::string(1000, '.') + "\"\n" +
                        changed(small_scene, "percuss = 1\n",
                                "percuss = 1\ndescription = '''" + std::string(1000, '.') + "'''''\n")),
              "");
}

TEST(BrokenScene, StopsListingWhenNobodyWouldReadOn) {
    std::string text = small_scene + "[record]\n";
    for (int i = 0; i < 1000; ++i) text += "k" + std::to_string(i) + " = 1\n";
    const auto faults = faults_of(text);
    EXPECT_LE(std::count(faults.begin(), faults.end(), '\n'), 51);
}

}  // namespace
}  // namespace percuss::testing
