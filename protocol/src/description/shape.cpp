#include "shape.hpp"

#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <iterator>
#include <span>

#include "members.hpp"

namespace blossom::protocol {

namespace {

std::string listed_words(const std::vector<std::string_view>& words, std::string_view quote) {
    return listed(
        mapped(words, [&](std::string_view word) { return std::string(quote).append(word).append(quote); }));
}

std::shared_ptr<const Shape> shared(Shape shape) { return std::make_shared<const Shape>(std::move(shape)); }

Json array_schema(Json element, std::size_t least, std::size_t most) {
    if (element.is_null()) return {};
    Json schema = Json::Object{{"type", "array"}, {"items", std::move(element)}};
    if (least > 0) schema["minItems"] = least;
    if (most != SIZE_MAX) schema["maxItems"] = most;
    return schema;
}

template <class... Functions>
struct Cases : Functions... {
    using Functions::operator()...;
};

}  // namespace

std::string listed(const std::vector<std::string>& parts) {
    if (parts.size() < 2) return parts.empty() ? "" : parts.front();
    return joined(std::span(parts).first(parts.size() - 1)) + " or " + parts.back();
}

Shape Shape::words(std::vector<std::string_view> words) { return Shape(Words{std::move(words)}); }
Shape Shape::list(Shape element, std::size_t least, std::size_t most) {
    return Shape(List{shared(std::move(element)), least, most});
}
Shape Shape::pair(Shape first, Shape second) {
    return Shape(Pair{shared(std::move(first)), shared(std::move(second))});
}
Shape Shape::one_of(std::vector<Shape> alternatives) { return Shape(OneOf{std::move(alternatives)}); }
Shape Shape::object(Members members) {
    return Shape(Object(std::make_shared<const Members>(std::move(members))));
}
Shape Shape::names(Shape member) { return Shape(Names{shared(std::move(member))}); }
Shape Shape::request_of(std::vector<std::string_view> operations) {
    return Shape(RequestOf{std::move(operations)});
}

Shape Shape::united(const Shape& first, const Shape& second) {
    const auto* words = std::get_if<Words>(&first.value_);
    const auto* more_words = std::get_if<Words>(&second.value_);
    if (words && more_words) {
        Words all = *words;
        for (const std::string_view word : more_words->words) {
            if (std::ranges::find(all.words, word) == all.words.end()) all.words.push_back(word);
        }
        return Shape(std::move(all));
    }
    std::vector<Shape> all;
    for (const Shape* shape : {&first, &second}) {
        const auto* one = std::get_if<OneOf>(&shape->value_);
        for (const Shape& alternative : one ? one->alternatives : std::vector{*shape}) {
            const bool is_new = std::ranges::none_of(
                all, [&](const Shape& other) { return other.text() == alternative.text(); });
            if (is_new) all.push_back(alternative);
        }
    }
    return all.size() == 1 ? all.front() : one_of(std::move(all));
}

std::vector<std::string_view> Shape::alternatives() const {
    const auto* words = std::get_if<Words>(&value_);
    return words ? words->words : std::vector<std::string_view>{};
}

std::string Shape::text(std::string_view quote) const {
    const auto both = [&](const Shape& first, const Shape& second) {
        return "[" + first.text(quote) + ", " + second.text(quote) + "]";
    };
    return std::visit(Cases{
                          [](ValueKind kind) { return std::string(text_of(kind)); },
                          [&](const Words& words) { return listed_words(words.words, quote); },
                          [&](const List& list) { return "list of " + list.element->plural(quote); },
                          [&](const Pair& pair) { return "pair " + both(*pair.first, *pair.second); },
                          [&](const OneOf& one) {
                              return listed(mapped(one.alternatives,
                                                   [&](const Shape& shape) { return shape.text(quote); }));
                          },
                          [](const Object&) { return std::string("object"); },
                          [&](const Names& names) { return "object of " + names.member->plural(quote); },
                          [&](const RequestOf& request) {
                              return "request for " + listed_words(request.operations, quote);
                          },
                      },
                      value_);
}

std::string Shape::plural(std::string_view quote) const {
    if (const auto* kind = std::get_if<ValueKind>(&value_)) return std::string(plural_of(*kind));
    if (const auto* list = std::get_if<List>(&value_)) return "lists of " + list->element->plural(quote);
    if (const auto* one = std::get_if<OneOf>(&value_)) {
        return listed(mapped(one->alternatives, [&](const Shape& shape) { return shape.plural(quote); }));
    }
    std::string singular = text(quote);
    const std::size_t end = std::min(singular.find(' '), singular.size());
    return std::holds_alternative<Words>(value_) ? singular : singular.insert(end, "s");
}

Json Shape::schema(Side side) const {
    return std::visit(
        Cases{
            [&](ValueKind kind) { return schema_of(kind, side); },
            [](const Words& words) -> Json {
                return Json::Object{{"enum", Json::Array(words.words.begin(), words.words.end())}};
            },
            [&](const List& list) { return array_schema(list.element->schema(side), list.least, list.most); },
            [&](const Pair& pair) -> Json {
                Json first = pair.first->schema(side);
                Json second = pair.second->schema(side);
                if (first.is_null() || second.is_null()) return {};
                return Json::Object{{"type", "array"},
                                    {"prefixItems", Json::Array{std::move(first), std::move(second)}},
                                    {"minItems", std::size_t{2}},
                                    {"maxItems", std::size_t{2}}};
            },
            [&](const OneOf& one) -> Json {
                Json::Array schemas =
                    mapped(one.alternatives, [&](const Shape& shape) { return shape.schema(side); });
                std::erase(schemas, Json());
                if (schemas.size() <= 1) return schemas.empty() ? Json() : schemas.front();
                return Json::Object{{"anyOf", std::move(schemas)}};
            },
            [&](const Object& members) { return object_schema(*members, side); },
            [&](const Names& names) -> Json {
                Json member = names.member->schema(side);
                if (member.is_null()) return {};
                Json schema = Json::Object{{"type", "object"}};
                if (side == Side::result && names.member->has_numbers()) {
                    schema["patternProperties"] =
                        Json::Object{{"_double$", reference_to("rounded")},
                                     {"_hex$", reference_to("rounded_hexadecimal")}};
                }
                schema["additionalProperties"] = std::move(member);
                return schema;
            },
            [](const RequestOf& request) -> Json {
                Json::Array schemas;
                for (const std::string_view name : request.operations)
                    schemas.push_back(reference_to(std::string(name) + "_request"));
                return Json::Object{{"anyOf", std::move(schemas)}};
            },
        },
        value_);
}

bool Shape::has_numbers() const {
    return std::visit(
        Cases{
            [](ValueKind kind) {
                constexpr ValueKind numeric[] = {ValueKind::number,   ValueKind::point,
                                                 ValueKind::interval, ValueKind::nested_points,
                                                 ValueKind::argument, ValueKind::point_argument};
                return std::ranges::find(numeric, kind) != std::end(numeric);
            },
            [](const List& list) { return list.element->has_numbers(); },
            [](const Pair& pair) { return pair.first->has_numbers() || pair.second->has_numbers(); },
            [](const OneOf& one) { return std::ranges::any_of(one.alternatives, &Shape::has_numbers); },
            [](const auto&) { return false; },
        },
        value_);
}

}  // namespace blossom::protocol
