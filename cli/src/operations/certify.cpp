#include <fmt/format.h>
#include <blossom/core/conversion.hpp>
#include <blossom/core/polynomial_text.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

#include "answer.hpp"
#include "certificate.hpp"
#include "json_text.hpp"
#include "maps/serve.hpp"
#include "operations/blossom_arguments.hpp"
#include "operations/listing.hpp"
#include "operations/map_options.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

/// What the numbers of a map say about the blossom p of degree n of the map of which it is the derivative of
/// that order. Bezier curves: P_k = n!/(n-r)! p(a^(m-k), b^k, delta^r). Taylor forms, polynomials about 0:
/// c_k = n!/(n-r)! C(m, k) p(a^(m-k), delta^(r+k)). Source: Goldman, theorems 4 and 9, equation 4.4.
struct StatedValues {
    std::size_t degree;
    std::size_t order;

    std::vector<CertifiedValue> operator()(const BezierCurve& curve) const {
        const Interval& interval = curve.interval();
        return values(curve.control_points(), Parameter(interval.a()), Parameter(interval.b()),
                      "control point", [](std::size_t) { return Integer(1); });
    }
    std::vector<CertifiedValue> operator()(const TaylorCurve& curve) const {
        const std::size_t m = curve.coefficients.size() - 1;
        return values(curve.coefficients, Parameter(curve.center), delta, "coefficient",
                      [m](std::size_t k) { return binomial(m, k); });
    }
    std::vector<CertifiedValue> operator()(const PolynomialCurve& curve) const {
        return (*this)(TaylorCurve{Rational(0), curve.coefficients()});
    }

private:
    template <class Multiple>
    std::vector<CertifiedValue> values(const PointArray& points, const Argument& first, const Argument& last,
                                       std::string_view name, const Multiple& multiple) const {
        std::vector<CertifiedValue> list;
        for (const Coordinates& point : points.to_points()) {
            const std::size_t k = list.size();
            std::vector<Argument> arguments = with_copies({}, points.size() - 1 - k, first);
            arguments = with_copies(std::move(arguments), k, last);
            // Derivatives of an order above the degree are zero: 0 times any value.
            arguments.resize(std::min(arguments.size(), degree - std::min(order, degree)), delta);
            list.push_back({fmt::format("{} {}", name, k),
                            with_copies(std::move(arguments), std::min(order, degree), delta),
                            falling_factorial(degree, order) * multiple(k), point});
        }
        return list;
    }
};

struct PowerForm {
    const Limits& limits;

    PolynomialCurve operator()(const PolynomialCurve& curve) const { return curve; }
    PolynomialCurve operator()(const BezierCurve& curve) const { return monomial_form(curve, limits); }
    PolynomialCurve operator()(const TaylorCurve& curve) const { return monomial_form(curve, limits); }
};

PolynomialCurve with_degree(const PolynomialCurve& curve, std::size_t degree) {
    std::vector<Coordinates> coefficients = curve.coefficients().to_points();
    coefficients.resize(degree + 1, Coordinates(curve.dimension()));
    return PolynomialCurve(coefficients);
}

/// A request that has been answered, and what it was about.
struct Question {
    const Json& request;
    const Json& result;
    const Map& map;
    Certificate& certificate;
    const Limits& limits;

    const PolynomialCurve& curve() const { return certificate.maps.front().curve; }
    std::size_t degree() const { return curve().degree(); }
    Coordinates point(const Json& value) const {
        return read_point(value, map.form, curve().dimension(), limits);
    }
    std::vector<Argument> arguments() const {
        return read_arguments(*request.find("arguments"), map.form, limits);
    }
    void claim(CertifiedValue value) const { certificate.maps.back().values.push_back(std::move(value)); }
    void claim_all(std::vector<CertifiedValue> values) const {
        std::ranges::move(values, std::back_inserter(certificate.maps.back().values));
    }
};

void certify_blossom(const Question& question) {
    question.claim({"value", question.arguments(), 1, question.point(*question.result.find("value"))});
}

/// The coefficients of the elementary symmetric functions: C(n, k) p(0^(n-k), delta^k) / C(n, k).
void certify_expansion(const Question& question) {
    const std::size_t n = question.degree();
    const Json& elementary = *question.result.find("elementary");
    const std::vector<std::string> names = numbered_names("e", n);
    std::vector<Coordinates> coefficients(n + 1, Coordinates(question.curve().dimension()));
    for (std::size_t j = 0; j < coefficients.front().size(); ++j) {
        const std::string& text = *(elementary.array() ? (*elementary.array())[j] : elementary).text();
        const SparsePolynomial read = parse_polynomial(text, names, question.limits).polynomial;
        for (std::size_t term = 0; term < read.size(); ++term) {
            std::size_t k = 0;
            for (std::size_t i = 0; i < n; ++i) k += read.exponent(term, i) * (i + 1);
            coefficients[k][j] = read.coefficient(term);
        }
    }
    for (std::size_t k = 0; k <= n; ++k) {
        question.claim({fmt::format("coefficient of e{}", k),
                        with_copies(with_copies({}, n - k, Parameter(0)), k, delta), 1, coefficients[k]});
    }
}

void certify_agree(const Question& question) {
    if (!question.request.find("arguments")) {
        certify_expansion(question);
        return;
    }
    for (const auto& [construction, value] : *question.result.find("values")->object())
        question.claim({construction, question.arguments(), 1, question.point(value)});
}

void certify_control_points(const Question& question) {
    const Map points = result_map(*question.result.find("map"), question.limits);
    const auto& curve = std::get<BezierCurve>(points.value);
    if (curve.degree() != question.degree())
        question.certificate.maps.push_back({with_degree(question.curve(), curve.degree()), {}});
    question.claim_all(StatedValues{curve.degree(), 0}(curve));
}

void certify_derivative(const Question& question) {
    const std::size_t n = question.degree();
    const Json* written = question.request.find("order");
    const std::size_t order = written ? read_count(*written, question.limits) : 1;
    if (const Json* map = question.result.find("map")) {
        question.claim_all(
            serve<std::vector<CertifiedValue>>(result_map(*map, question.limits), StatedValues{n, order}));
        return;
    }
    const std::vector<Rational> parameters = read_numbers(*question.request.find("at"), question.limits);
    const Json::Array& values = *question.result.find("values")->array();
    const std::size_t vectors = std::min(order, n);
    for (std::size_t i = 0; i < values.size(); ++i) {
        question.claim({fmt::format("derivative {} at {}", order, to_string(parameters[i])),
                        with_copies(with_copies({}, n - vectors, Parameter(parameters[i])), vectors, delta),
                        falling_factorial(n, order), question.point(values[i])});
    }
}

struct Certified {
    std::string_view operation;
    void (*certify)(const Question& question);
};

constexpr Certified certified[] = {
    {"agree", certify_agree},
    {"blossom", certify_blossom},
    {"control-points", certify_control_points},
    {"derivative", certify_derivative},
};

const Certified& read_operation(const Json& value) {
    std::vector<std::string_view> names;
    for (const Certified& entry : certified) names.push_back(entry.operation);
    return certified[read_alternative(value, names, "an operation with certificates")];
}

Certificate certificate_of(const Json& request, const Limits& limits) {
    Fields fields(request);
    const Certified& entry = fields.required("op", read_operation);
    // What is certified is what is printed, so the answer is read back from its text.
    const Json result = parse_json(to_text(result_of(request, limits)), limits);
    const Map map = read_map_field(fields, limits);
    if (map.form.separate_weights()) {
        throw Error(ErrorCode::wrong_kind,
                    "the values of a rational map are quotients; with \"homogeneous\": true they carry their "
                    "weight and have certificates",
                    "/map");
    }
    CertifiedMap given{serve<PolynomialCurve>(map, PowerForm{limits}), {}};
    if (!std::holds_alternative<PolynomialCurve>(map.value)) {
        // They say that the polynomial is the curve that was given: its points determine it.
        given.values = serve<std::vector<CertifiedValue>>(map, StatedValues{given.curve.degree(), 0});
        for (CertifiedValue& value : given.values) value.name.insert(0, "given ");
    }
    Certificate certificate{std::string(entry.operation), {std::move(given)}};
    entry.certify({request, result, map, certificate, limits});
    std::erase_if(certificate.maps, [](const CertifiedMap& claims) { return claims.values.empty(); });
    return certificate;
}

Json answer(Fields& request, const Limits& limits) {
    const auto certificates = request.required("requests", [&](const Json& value) {
        return read_list(value, [&](const Json& element) { return certificate_of(element, limits); });
    });
    request.finish();
    return Json::Object{{"document", coq_file(certificates, limits)}};
}

std::string render(const Answered& answered) { return *answered.result.find("document")->text(); }

/// One request a line.
void apply_requests(Json& request, const std::vector<std::string>& values, const Limits& limits) {
    Json::Array requests;
    for (const std::string& value : values) {
        for (const std::string& line : split(value, '\n'))
            if (!line.empty()) requests.push_back(parse_json(line, limits));
    }
    request["requests"] = std::move(requests);
}

}  // namespace

Operation certify_operation() {
    return {
        .name = "certify",
        .summary = "The answers to requests as a file in which Coq checks every number",
        .example = {"certify",
                    R"({"op":"blossom","map":{"kind":"polynomial","text":"1 + 2t"},"arguments":["1/2"]})"},
        .options = {{"REQUEST", "/requests", "JSON",
                     "requests for agree, blossom, control-points or derivative, each on a line",
                     apply_requests}},
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::cli
