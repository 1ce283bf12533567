#include "obj.hpp"

#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>

#include "mesh.hpp"
#include "operations/listing.hpp"

namespace blossom::protocol {

namespace {

/// One element of a file: "f 1 2 3". The file numbers its vertices from 1.
void add_element(std::string& text, char kind, const std::vector<std::size_t>& places, std::size_t before) {
    text += kind;
    for (const std::size_t place : places) text += fmt::format(" {}", before + place + 1);
    text += '\n';
}

}  // namespace

std::string obj_of(const Answered& answered) {
    const std::vector<Map>& maps =
        answered.answer.maps.empty() ? answered.answer.given : answered.answer.maps;
    std::string text = "# blossom\n";
    std::size_t before = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Mesh mesh = mesh_of(maps[i], answered.limits);
        text += maps.size() == 1 ? "o surface\n" : fmt::format("o surface_{}\n", i + 1);
        for (const SpacePoint& place : mesh.places) {
            text += fmt::format("v {} {} {}\n", nearest_double(place.x), nearest_double(place.y),
                                nearest_double(place.z));
        }
        for (const GridCell& cell : mesh.cells) add_element(text, 'f', cell.corners, before);
        for (const auto& curve : mesh.curves) add_element(text, 'l', curve, before);
        before += mesh.places.size();
    }
    return text;
}

}  // namespace blossom::protocol
