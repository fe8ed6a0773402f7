#include "image.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>

namespace percuss::render {

void write_png(const Image& image, const std::filesystem::path& file) {
    const auto row = 3 * static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || image.pixels.size() != row * height)
        throw RenderError(fmt::format("{}: the picture is empty or its size is wrong", file.string()));
    const auto data = vtkSmartPointer<vtkImageData>::New();
    data->SetDimensions(image.width, image.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixels = static_cast<std::uint8_t*>(data->GetScalarPointer());
    for (std::size_t y = 0; y < height; ++y)
        std::copy_n(image.pixels.data() + row * (height - 1 - y), row, pixels + row * y);
    const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    writer->SetCompressionLevel(4);
    writer->GlobalWarningDisplayOff();  // the error is reported below, by exception
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    writer->Write();
    writer->GlobalWarningDisplayOn();
    if (writer->GetErrorCode() != vtkErrorCode::NoError || !std::filesystem::exists(file))
        throw RenderError(fmt::format("{}: cannot be written ({})", file.string(),
                                      vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())));
}

std::string base64_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(in),
                                           std::istreambuf_iterator<char>()};
    if (bytes.empty()) throw RenderError(fmt::format("{}: cannot be read", file.string()));
    std::vector<unsigned char> text(4 * (bytes.size() / 3 + 1) + 4);
    const auto size =
        vtkBase64Utilities::Encode(bytes.data(), static_cast<unsigned long>(bytes.size()), text.data());
    return {text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size)};
}

Image read_png(const std::filesystem::path& file) {
    const auto reader = vtkSmartPointer<vtkPNGReader>::New();
    if (!std::filesystem::is_regular_file(file) || reader->CanReadFile(file.c_str()) == 0)
        throw RenderError(fmt::format("{}: is not a readable PNG file", file.string()));
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkImageData* data = reader->GetOutput();
    const int* size = data->GetDimensions();
    const int components = data->GetNumberOfScalarComponents();
    if (data->GetScalarType() != VTK_UNSIGNED_CHAR || components < 1)
        throw RenderError(fmt::format("{}: has no 8-bit colours", file.string()));
    Image image{size[0], size[1], {}};
    image.pixels.reserve(3 * static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
    for (int y = size[1] - 1; y >= 0; --y)
        for (int x = 0; x < size[0]; ++x) {
            const auto* pixel = static_cast<const std::uint8_t*>(data->GetScalarPointer(x, y, 0));
            for (int c = 0; c < 3; ++c) image.pixels.push_back(pixel[components < 3 ? 0 : c]);
        }
    return image;
}

}  // namespace percuss::render
