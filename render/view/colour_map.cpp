#include "view/colour_map.hpp"

#include <map>
#include <vector>

#include <vtkColorTransferFunction.h>

#include "image.hpp"
#include "nearest_name.hpp"
#include "run/fields.hpp"

namespace percuss::render {

namespace {

/// Evenly spaced anchors, 0xRRGGBB. The perceptual maps (van der Walt & Smith 2015, Nunez et al. 2018) are
/// smooth enough that ten anchors joined in Lab space stay within a shade that no eye tells apart.
const std::map<std::string, std::vector<unsigned>>& anchors() {
    static const std::map<std::string, std::vector<unsigned>> table{
        {"viridis",
         {0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c,
          0xfde725}},
        {"plasma",
         {0x0d0887, 0x47039f, 0x7301a8, 0x9c179e, 0xbd3786, 0xd8576b, 0xed7953, 0xfa9e3b, 0xfdc926,
          0xf0f921}},
        {"cividis",
         {0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173, 0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b,
          0xffea46}},
        {"magma",
         {0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f, 0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d,
          0xfcfdbf}},
        {"inferno",
         {0x000004, 0x1b0c42, 0x4b0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6925, 0xfb9a06, 0xf7d03c,
          0xfcffa4}},
        {"grey", {0x303030, 0xf4f4f4}},
        {"coolwarm", {0x3b4cc0, 0xb40426}},
    };
    return table;
}

}  // namespace

vtkSmartPointer<vtkLookupTable> make_colour_map(const std::string& name) {
    const auto found = anchors().find(name);
    if (found == anchors().end())
        throw RenderError("unknown colour map '" + name + "'" + suggest_name(name, colour_map_names()));
    const std::vector<unsigned>& colours = found->second;
    const auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
    if (name == "coolwarm")
        function->SetColorSpaceToDiverging();  // Moreland 2009: passes through a light grey
    else
        function->SetColorSpaceToLab();
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const unsigned c = colours[i];
        function->AddRGBPoint(static_cast<double>(i) / static_cast<double>(colours.size() - 1),
                              (c >> 16U & 255U) / 255.0, (c >> 8U & 255U) / 255.0, (c & 255U) / 255.0);
    }
    constexpr int size = 256;
    const auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(size);
    for (int i = 0; i < size; ++i) {
        double rgb[3];
        function->GetColor(i / (size - 1.0), rgb);
        table->SetTableValue(i, rgb[0], rgb[1], rgb[2], 1);
    }
    return table;
}

}  // namespace percuss::render
