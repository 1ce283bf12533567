#include "responses.hpp"

#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <exception>
#include <new>
#include <optional>

#include "floats.hpp"
#include "json/fields.hpp"
#include "json/json_text.hpp"
#include "json/nearest_name.hpp"
#include "rounding.hpp"
#include "typed_numbers.hpp"

namespace blossom::protocol {

namespace {

Json response_to(const Json& request, std::string_view name, Json value) {
    Json::Object response;
    constexpr std::size_t most_members = 3;
    response.reserve(most_members);
    if (const Json* id = request.find("id")) response.emplace_back("id", *id);
    response.emplace_back("ok", name == "result");
    response.emplace_back(name, std::move(value));
    return response;
}

std::size_t digits_in(const Json& value) {
    if (const Rational* number = value.exact()) {
        // log10(2) < 1/3
        return (number->numerator().bit_length() + number->denominator().bit_length()) / 3 + 1;
    }
    std::size_t digits = 0;
    if (const Json::Array* elements = value.array()) {
        for (const Json& element : *elements) digits += digits_in(element);
    }
    if (const Json::Object* members = value.object()) {
        for (const auto& [name, member] : *members) digits += digits_in(member);
    }
    return digits;
}

/// Refuses a result that would take too long to write.
void require_output_digits(const Json& result, const Limits& limits) {
    require_within(digits_in(result), limits.output_digits, "output_digits",
                   "the size of the result in decimal digits, at most");
}

Response written(Json response) {
    const Json* result = response.find("result");
    const Outcome outcome = result ? outcome_of(*result) : Outcome::refused;
    return {to_text(std::move(response)), outcome};
}

/// The value of `answer`, or the response to its error, which is written after the budget of `answer` has
/// ended.
template <class Answering>
Json answered(const Json& request, ErrorMembers add, const Answering& answer) {
    try {
        return answer();
    } catch (const Error& error) {
        return error_response(request, error, add);
    } catch (const std::exception& problem) {
        return error_response(request, unexpected(problem), add);
    }
}

}  // namespace

FieldList common_fields() {
    return {{"id", ValueKind::any, Presence::optional, "is returned unchanged in the response"},
            {"numbers", Shape::words(rounding_names()), Presence::optional,
             "adds each exact number correctly rounded"},
            {"floats", Shape::words(floats_names()), Presence::optional,
             "what JSON numbers stand for, which are refused without it unless they are integers"}};
}

const Operation& find_operation(std::string_view name) {
    if (const Operation* found = operation_of(name)) return *found;
    const std::vector<std::string_view> names = mapped(operations(), &Operation::name);
    throw Error(ErrorCode::unknown_op, "the operation " + quoted(name) + " is not known" +
                                           suggestion(name, names) + "; known are: " + joined(names));
}

namespace {

Answer answer_of_fields(Request fields, const Limits& limits) {
    static_cast<void>(fields.optional("id", [](const Json& id) { return &id; }));
    const Operation& operation = fields.required(
        "op", [](const Json& name) -> const Operation& { return find_operation(read_text(name)); });
    const Rounding rounding = fields.optional("numbers", read_rounding).value_or(Rounding::none);
    static_cast<void>(fields.optional("floats", read_floats));
    Answer answer = operation.answer(fields, limits);
    fields.finish();
    require_output_digits(answer.result, limits);
    add_rounded_numbers(answer.result, rounding);
    answer.given = std::move(fields).given();
    return answer;
}

}  // namespace

Answer find_answer(const Json& request, const Limits& limits) {
    const std::optional<Json> exact = with_exact_floats(request, limits);
    const Json& read = exact ? *exact : request;
    try {
        return answer_of_fields(Request(read), limits);
    } catch (const Error& error) {
        const bool names_domain =
            error.code() == ErrorCode::outside_domain && error.message().find("domain") != std::string::npos;
        if (!names_domain) throw;
        throw error.saying(with_typed_numbers(error.message(), request, read));
    }
}

Json success_response(const Json& request, Json result) {
    return response_to(request, "result", std::move(result));
}

Json error_response(const Json& request, const Error& error, ErrorMembers add) {
    Json::Object members{
        {"code", error_name(error.code())}, {"message", error.message()}, {"at", pointer_of(error.place())}};
    if (!error.limit().empty()) members.emplace_back("limit", error.limit());
    if (add) add(error, members);
    return response_to(request, "error", std::move(members));
}

Outcome outcome_of(const Json& result) {
    const Json* agree = result.find("agree");
    return agree && !*agree->boolean() ? Outcome::disagreement : Outcome::success;
}

Error unexpected(const std::exception& problem) {
    if (const auto* memory = dynamic_cast<const std::bad_alloc*>(&problem)) return resource_error(*memory);
    return {ErrorCode::internal, std::string("an error of the program: ") + problem.what()};
}

Json answer_to(const Json& request, const Limits& limits) {
    return answered(request, nullptr, [&] {
        const ResourceBudget budget(limits);
        return success_response(request, find_answer(request, limits).result);
    });
}

Response answer(std::string_view text, const Limits& limits) { return answer(text, limits, nullptr); }

Response answer(std::string_view text, const Limits& limits, ErrorMembers add) {
    Json request;
    std::optional<Response> response;
    Json refusal = answered(request, add, [&] {
        const ResourceBudget budget(limits);
        auto [value, error] = read_json(text, limits);
        request = std::move(value);
        if (error) throw Error(*error);
        response = written(success_response(request, find_answer(request, limits).result));
        return Json();
    });
    return response ? *std::move(response) : written(std::move(refusal));
}

Response refuse_long_line(const Limits& limits, ErrorMembers add) {
    return written(
        error_response(Json(), limit_error("the line is longer than", "line_bytes", limits.line_bytes), add));
}

}  // namespace blossom::protocol
