#include "mathml.hpp"

#include <string>
#include <string_view>

#include "document/letters.hpp"

namespace blossom::worked {

namespace {

using Kind = Layout::Kind;

class Markup : public pugi::xml_writer {
public:
    void write(const void* data, size_t size) override { text.append(static_cast<const char*>(data), size); }
    std::string text;
};

void append_token(pugi::xml_node parent, const char* element, std::string_view text) {
    parent.append_child(element).text().set(std::string(text).c_str());
}

void append(pugi::xml_node parent, const Layout& layout);

void append_operator(pugi::xml_node parent, std::string_view text, const char* space = nullptr) {
    pugi::xml_node node = parent.append_child("mo");
    node.text().set(std::string(text).c_str());
    if (space) {
        // At the beginning of a line a sign is not one in front of a number.
        node.append_attribute("form") = "infix";
        node.append_attribute("lspace") = space;
        node.append_attribute("rspace") = space;
    }
}

void append_fence(pugi::xml_node parent, std::string_view text) {
    pugi::xml_node node = parent.append_child("mo");
    node.text().set(std::string(text).c_str());
    node.append_attribute("stretchy") = "false";
    node.append_attribute("lspace") = "0";
    node.append_attribute("rspace") = "0";
}

void append_all(pugi::xml_node parent, const char* element, const Layout& layout) {
    pugi::xml_node node = parent.append_child(element);
    for (const Layout& part : layout.parts) append(node, part);
}

void append_fenced(pugi::xml_node parent, const Layout& layout) {
    const std::size_t half = layout.text.size() / 2;
    pugi::xml_node row = parent.append_child("mrow");
    // Arguments are written small, so that parentheses around them need not grow.
    row.append_attribute("displaystyle") = "false";
    append_fence(row, layout.text.substr(0, half));
    append(row, layout.parts.front());
    append_fence(row, layout.text.substr(half));
}

void append_stack(pugi::xml_node parent, const Layout& layout) {
    pugi::xml_node row = parent.append_child("mrow");
    append_fence(row, "(");
    pugi::xml_node fraction = row.append_child("mfrac");
    fraction.append_attribute("linethickness") = "0";
    for (const Layout& part : layout.parts) append(fraction, part);
    append_fence(row, ")");
}

void append_cases(pugi::xml_node parent, const Layout& layout) {
    pugi::xml_node row = parent.append_child("mrow");
    row.append_child("mo").text().set("{");
    pugi::xml_node table = row.append_child("mtable");
    table.append_attribute("columnalign") = "left";
    pugi::xml_node first = table.append_child("mtr");
    append(first.append_child("mtd"), layout.parts[0]);
    pugi::xml_node condition = first.append_child("mtd");
    append_token(condition, "mtext", "if\u00a0");
    append(condition, layout.parts[1]);
    pugi::xml_node second = table.append_child("mtr");
    append(second.append_child("mtd"), layout.parts[2]);
    append_token(second.append_child("mtd"), "mtext", "otherwise");
}

/// Both scripts of a name stand above each other.
void append_superscript(pugi::xml_node parent, const Layout& layout) {
    const Layout& base = layout.parts[0];
    if (base.kind != Kind::subscript) return append_all(parent, "msup", layout);
    pugi::xml_node node = parent.append_child("msubsup");
    for (const Layout* part : {&base.parts.front(), &base.parts[1], &layout.parts[1]}) append(node, *part);
}

void append(pugi::xml_node parent, const Layout& layout) {
    switch (layout.kind) {
        case Kind::number:
            return append_token(parent, "mn", layout.text);
        case Kind::identifier:
            return append_token(parent, "mi", letter(layout.text).unicode);
        case Kind::words:
            return append_token(parent, "mtext", layout.text);
        case Kind::relation:
            return append_operator(parent, layout.text, "0.3em");
        case Kind::binary:
            return append_operator(parent, layout.text, "0.25em");
        case Kind::sign:
            return append_fence(parent, layout.text);
        case Kind::times:
            return append_operator(parent, "\u2062");
        case Kind::apply:
            return append_operator(parent, "\u2061");
        case Kind::comma:
            return append_operator(parent, layout.text);
        case Kind::fraction:
            return append_all(parent, "mfrac", layout);
        case Kind::superscript:
            return append_superscript(parent, layout);
        case Kind::subscript:
            return append_all(parent, "msub", layout);
        case Kind::fenced:
            return append_fenced(parent, layout);
        case Kind::under:
            return append_all(parent, layout.parts.size() == 3 ? "munderover" : "munder", layout);
        case Kind::cases:
            return append_cases(parent, layout);
        case Kind::stack:
            return append_stack(parent, layout);
        case Kind::row:
            return append_all(parent, "mrow", layout);
    }
}

}  // namespace

pugi::xml_node append_math(pugi::xml_node parent, const Layout& layout, bool display) {
    pugi::xml_node math = parent.append_child("math");
    if (display) math.append_attribute("displaystyle") = "true";
    append(math, layout);
    return math;
}

std::string markup_of(const pugi::xml_document& document) {
    Markup markup;
    document.save(markup, "", pugi::format_raw | pugi::format_no_declaration, pugi::encoding_utf8);
    return std::move(markup.text);
}

std::string to_mathml(const Formula& formula, const Notation& notation, bool display) {
    pugi::xml_document document;
    append_math(document.root(), layout_of(formula, notation), display);
    return markup_of(document);
}

}  // namespace blossom::worked
