#pragma once

#include <blossom/worked/document.hpp>

#include <string>
#include <vector>

namespace blossom::worked {

/// A page of the gallery: a chapter on an example of the literature.
struct GalleryPage {
    std::string name;  ///< of its files
    Document document;
};

/// All chapters, in the order of teaching.
std::vector<GalleryPage> gallery_pages();

/// A file by its path within a folder.
struct SiteFile {
    std::string path;
    std::string content;
};

/// A small site: index.html, a page for each chapter with links to its neighbours, each also as LaTeX,
/// Markdown and JSON, and its pictures as pictures/NAME-1.svg, ....
std::vector<SiteFile> gallery_files();

}  // namespace blossom::worked
