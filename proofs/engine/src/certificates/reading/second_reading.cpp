#include "second_reading.hpp"

#include "certificates/evaluation/second_counting.hpp"
#include "second_names.hpp"
#include "second_parser.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <functional>

namespace blossom::proofs::second {

Reading::Reading(std::string_view block_text, const Limits& limits) : limits_(limits) {
    Parser(block_text, *this).parse_block();
    NameTable(*this).resolve();
}

std::vector<Case> Reading::cases() const {
    std::vector<Case> found;
    Counting counting(*this, {});
    Scope none;
    const auto add_cases_of_line = [&](std::size_t line) {
        const Statement& claim = claims_[line];
        Scope scope(claim.slots);
        counting.each_range(claim.ranges, scope, [&] {
            require_within(found.size() + 1, limits_.numbers, "numbers", "the number of cases");
            Case made;
            made.line = line;
            for (std::size_t i = 0; i < parameters_.size(); ++i) {
                made.parameters.emplace_back(names_[parameters_[i].name], counting.parameters()[i]);
            }
            for (std::size_t i = 0; i < claim.ranges.size(); ++i) {
                made.parameters.emplace_back(names_[claim.ranges[i].name], scope[i].integer);
            }
            found.push_back(std::move(made));
        });
    };
    const std::function<void(std::size_t, std::size_t)> choose = [&](std::size_t line, std::size_t place) {
        if (place == parameters_.size()) return add_cases_of_line(line);
        const long long low = counting.integer(parameters_[place].low, none);
        const long long high = counting.integer(parameters_[place].high, none);
        for (long long value = low; value <= high; ++value) {
            counting.work().step();
            counting.push_parameter(value);
            choose(line, place + 1);
            counting.pop_parameter();
        }
    };
    for (std::size_t line = 0; line < claims_.size(); ++line) choose(line, 0);
    return found;
}

bool Reading::is_map_value(std::string_view symbol) const {
    const std::size_t dot = symbol.find('.');
    const std::size_t bar = symbol.find('_');
    const std::string_view base = symbol.substr(0, std::min(dot, bar));
    return std::ranges::any_of(maps_, [&](const MapDeclaration& map) {
        if (dot != std::string_view::npos && bar == std::string_view::npos) {
            return map.kind == MapDeclaration::Kind::free && names_[map.name] == base;
        }
        return bar != std::string_view::npos && dot == std::string_view::npos &&
               map.kind == MapDeclaration::Kind::net && names_[map.family] == base;
    });
}

}  // namespace blossom::proofs::second
