#include "write_gallery.hpp"

#include <blossom/worked/gallery.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace blossom::cli {

Outcome write_gallery(const std::string& folder, const Streams& streams) {
    for (const worked::SiteFile& file : worked::gallery_files()) {
        const std::filesystem::path path = std::filesystem::path(folder) / file.path;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream stream(path, std::ios::binary);
        stream << file.content;
        if (!stream.flush()) throw std::system_error(errno, std::generic_category(), path.string());
    }
    streams.output((std::filesystem::path(folder) / "index.html").string() + "\n");
    return Outcome::success;
}

}  // namespace blossom::cli
