#pragma once

#include <blossom/worked/document.hpp>

#include <string>

namespace blossom::worked {

/// One visitor from a function for each alternative.
template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};

template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// A text in one format: words(string) and formula(formula) for its parts.
template <class Words, class OfFormula>
std::string written(const Text& text, const Words& words, const OfFormula& formula) {
    std::string all;
    for (const Text::Part& part : text.parts()) {
        const auto* string = std::get_if<std::string>(&part);
        all += string ? std::string(words(*string)) : formula(std::get<Formula>(part));
    }
    return all;
}

/// The parts of a page in their order, for formats that are text: `Format` has title(text), source(text),
/// heading(text), closing(text), block(content) for each kind of block, and `before_block`.
template <class Format>
std::string written(const Document& document, Format& format) {
    const auto blocks = [&](const Blocks& list) {
        std::string text;
        for (const Block& block : list)
            text += Format::before_block +
                    std::visit([&](const auto& content) { return format.block(content); }, block) + "\n";
        return text;
    };
    std::string text = format.title(document.title) + blocks(document.general) + blocks(document.statement);
    if (!document.source.empty()) text += format.source(document.source);
    for (std::size_t i = 0; i < document.steps.size(); ++i) {
        text += format.heading(std::to_string(i + 1) + ". " + document.steps[i].title) +
                blocks(document.steps[i].blocks);
    }
    if (!document.result.empty()) text += format.heading("Result") + blocks(document.result);
    if (!document.check) return text;
    return text + format.heading("Check") + blocks(document.check->blocks) +
           format.closing(said_of(*document.check)) + "\n";
}

}  // namespace blossom::worked
