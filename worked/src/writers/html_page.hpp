#pragma once

#include <blossom/worked/render.hpp>

#include <pugixml.hpp>

#include <string>
#include <vector>

namespace blossom::worked {

/// Appends an element with words.
pugi::xml_node append_words(pugi::xml_node parent, const char* element, const std::string& words);

/// A page of HTML with the style of all pages, still without content.
class HtmlPage {
public:
    explicit HtmlPage(const std::string& title);

    pugi::xml_node main() const { return main_; }
    /// Links to other pages, before the content.
    void append_navigation(const std::vector<Link>& links);
    std::string text() const;

private:
    pugi::xml_document document_;
    pugi::xml_node body_;
    pugi::xml_node main_;
};

}  // namespace blossom::worked
