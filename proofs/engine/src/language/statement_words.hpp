#pragma once

#include <blossom/proofs/syntax.hpp>

#include <optional>
#include <string_view>
#include <utility>

namespace blossom::proofs {

inline constexpr std::pair<StatementKind, std::string_view> statement_words[] = {
    {StatementKind::parameter, "for"},   {StatementKind::map, "map"},     {StatementKind::point, "point"},
    {StatementKind::vector, "vector"},   {StatementKind::frame, "frame"}, {StatementKind::number, "number"},
    {StatementKind::polynomial, "poly"}, {StatementKind::raise, "raise"}, {StatementKind::let, "let"},
    {StatementKind::assume, "assume"},   {StatementKind::given, "given"}, {StatementKind::claim, "claim"},
    {StatementKind::refute, "refute"},
};

inline std::optional<StatementKind> find_statement(std::string_view word) {
    for (const auto& [kind, name] : statement_words) {
        if (name == word) return kind;
    }
    return std::nullopt;
}

inline std::string_view statement_word(StatementKind kind) {
    for (const auto& [listed, name] : statement_words) {
        if (listed == kind) return name;
    }
    return "";
}

}  // namespace blossom::proofs
