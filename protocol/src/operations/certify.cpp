#include <fmt/format.h>
#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>

#include "along_direction.hpp"
#include "blossom_arguments.hpp"
#include "certificates/certificate.hpp"
#include "certified_curve.hpp"
#include "json/json_text.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "responses.hpp"
#include "segment.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

PolynomialCurve with_degree(const PolynomialCurve& curve, std::size_t degree) {
    std::vector<Coordinates> coefficients = curve.coefficients().to_points();
    coefficients.resize(degree + 1, Coordinates(curve.dimension()));
    return PolynomialCurve(coefficients);
}

/// A request with its answer and its map.
struct Question {
    const Json& request;
    const Answer& answer;
    std::optional<std::size_t> span;  ///< of a B-spline, where the request names one
    std::optional<Patch> patch;       ///< a tensor product, or its polynomial on a box of spans
    Certificate& certificate;
    const Limits& limits;

    const Map& map() const { return answer.given.front(); }
    const Json& result() const { return answer.result; }
    const PolynomialCurve& curve() const { return certificate.maps.back().curve; }
    std::size_t degree() const { return curve().degree(); }
    const BSplineCurve* spline() const { return std::get_if<BSplineCurve>(&map().value); }
    /// Selects the polynomial of a B-spline on the span that contains `t`.
    void turn_to(const Rational& t) const {
        certificate.maps.push_back(certified_map(map(), spline()->knots().span_at(t), limits));
    }
    /// States a value at `arguments`; for a rational map its homogeneous point, with the weight there.
    Coordinates point(const Json& value, std::span<const Argument> arguments) const {
        if (!map().form.separate_weights()) return read_point(value, map().form, curve().dimension(), limits);
        Coordinates point = read_point(value, {.scalar = map().form.scalar}, curve().dimension() - 1, limits);
        point.emplace_back(1);
        const Rational weight = Blossom(curve(), limits)(arguments).back();
        for (Rational& coordinate : point) coordinate *= weight;
        return point;
    }
    std::vector<Argument> arguments() const {
        return read_arguments(*request.find("arguments"), map().form, limits);
    }
    void claim(CertifiedValue value) const { certificate.maps.back().values.push_back(std::move(value)); }
    void claim_all(std::vector<CertifiedValue> values) const {
        std::ranges::move(values, std::back_inserter(certificate.maps.back().values));
    }
};

/// The tensor product in which the curve along a direction is one point.
Patch with_point_along(Patch patch, std::size_t direction, const Coordinates& point, const Limits& limits) {
    const std::vector<Coordinates> points{point};
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map)) {
        patch.map = with_curve_along(*polynomial, direction, PolynomialCurve(points));
        return patch;
    }
    return tensor_patch(
        with_curve_along(placed_tensor(patch, limits), direction, BezierCurve(points, Interval())));
}

/// A blossom value of a tensor product by the values of the curves along its directions, the last one first:
/// each has the rows for the next as its coordinates.
void certify_tensor(const Question& question, const Json::Object& values) {
    Patch patch = *question.patch;
    const Json::Array& lists = *question.request.find("arguments")->array();
    for (std::size_t d = lists.size(); d-- > 0;) {
        const std::vector<Argument> arguments =
            read_arguments(lists[d], question.map().form, question.limits);
        question.certificate.maps.push_back(certified_direction(patch, d, question.limits));
        if (d == 0) {
            for (const auto& [name, value] : values)
                question.claim({name, arguments, 1, question.point(value, arguments)});
            continue;
        }
        const Coordinates rows = Blossom(question.curve(), question.limits)(arguments);
        question.claim({fmt::format("rows for direction {}", d - 1), arguments, 1, rows});
        patch = with_point_along(std::move(patch), d, rows, question.limits);
    }
}

void certify_blossom(const Question& question) {
    if (question.patch) {
        certify_tensor(question, {{"value", *question.result().find("value")}});
        return;
    }
    if (question.spline())
        question.certificate.maps.push_back(certified_map(question.map(), question.span, question.limits));
    const std::vector<Argument> arguments = question.arguments();
    question.claim({"value", arguments, 1, question.point(*question.result().find("value"), arguments)});
}

/// Errors: `wrong_kind` for a tensor product.
void require_curve(const Question& question) {
    if (!question.patch) return;
    throw Error(ErrorCode::wrong_kind,
                "of a tensor product, a certificate is made of blossom values at given arguments",
                Place{"map"});
}

/// The coefficients of the elementary symmetric functions: C(n, k) p(0^(n-k), delta^k) / C(n, k).
void certify_expansion(const Question& question) {
    const std::size_t n = question.degree();
    const Json& elementary = *question.result().find("elementary");
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
    if (question.patch && question.request.find("arguments")) {
        certify_tensor(question, *question.result().find("values")->object());
        return;
    }
    require_curve(question);
    if (!question.request.find("arguments")) {
        certify_expansion(question);
        return;
    }
    const std::vector<Argument> arguments = question.arguments();
    for (const auto& [construction, value] : *question.result().find("values")->object())
        question.claim({construction, arguments, 1, question.point(value, arguments)});
}

/// The points of a curve of any degree that is the map, or its derivative of an order.
struct CertifyPoints {
    const Question& question;
    std::size_t order;

    void operator()(const OnePolynomial auto& curve) const {
        question.claim_all(claims(stated_values(curve), question.degree(), order));
    }
    void operator()(const BSplineCurve& curve) const {
        for (const std::size_t span : curve.knots().spans()) {
            question.turn_to(curve.knots()[span]);
            raise_to(curve.degree() + order);
            (*this)(segment(curve, span));
        }
    }
    /// Raises the formal degree of the polynomial for the later claims.
    void raise_to(std::size_t degree) const {
        if (degree > question.degree())
            question.certificate.maps.push_back({with_degree(question.curve(), degree), {}});
    }
};

void certify_control_points(const Question& question) {
    require_curve(question);
    const Map& points = question.answer.maps.front();
    const CertifyPoints certify{question, 0};
    if (const auto* curve = std::get_if<BezierCurve>(&points.value)) {
        if (question.spline()) question.turn_to(std::min(curve->interval().a(), curve->interval().b()));
        certify.raise_to(curve->degree());
    }
    dispatch_on_kind<void>(points, certify);
}

void certify_derivative(const Question& question) {
    require_curve(question);
    if (question.map().form.separate_weights()) {
        throw Error(
            ErrorCode::wrong_kind,
            "a derivative of a rational map comes from the quotient rule and is not a blossom value; with "
            "\"homogeneous\": true it has a certificate",
            Place{"map"});
    }
    const Json* written = question.request.find("order");
    const std::size_t order = written ? read_count(*written, question.limits) : 1;
    if (!question.answer.maps.empty()) {
        dispatch_on_kind<void>(question.answer.maps.front(), CertifyPoints{question, order});
        return;
    }
    const std::vector<Rational> parameters = read_numbers(*question.request.find("at"), question.limits);
    const Json::Array& values = *question.result().find("values")->array();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (question.spline()) question.turn_to(parameters[i]);
        const std::size_t n = question.degree();
        const std::size_t vectors = std::min(order, n);
        const std::vector<Argument> arguments =
            with_copies(with_copies({}, n - vectors, Parameter(parameters[i])), vectors, delta);
        question.claim({fmt::format("derivative {} at {}", order, to_string(parameters[i])), arguments,
                        falling_factorial(n, order), question.point(values[i], arguments)});
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

std::vector<std::string_view> certified_names() { return mapped(certified, &Certified::operation); }

const Certified& read_operation(const Json& value) {
    return certified[read_alternative(value, certified_names(), "an operation with certificates")];
}

/// The polynomial of a tensor product.
std::optional<Patch> tensor_of(Fields& request, const Map& map, const Limits& limits) {
    if (const auto* spline = std::get_if<TensorBSpline>(&map.value))
        return read_segment(request, *spline, limits);
    const auto* patch = std::get_if<Patch>(&map.value);
    return patch && patch->tensor ? std::optional(*patch) : std::nullopt;
}

Certificate certificate_of(const Json& request, const Limits& limits) {
    Fields fields(request);
    const Certified& entry = fields.required("op", read_operation);
    const Answer answer = find_answer(request, limits);
    const Map& map = answer.given.front();
    Certificate certificate{std::string(entry.operation), {}};
    const auto span = read_span(fields, map, limits);
    const std::optional<Patch> patch = tensor_of(fields, map, limits);
    // The polynomials of a spline are selected by the parameters of the request.
    if (!patch && !std::holds_alternative<BSplineCurve>(map.value))
        certificate.maps.push_back(certified_map(map, span, limits));
    entry.certify({request, answer, span, patch, certificate, limits});
    std::erase_if(certificate.maps, [](const CertifiedMap& claims) { return claims.values.empty(); });
    return certificate;
}

Answer answer_certify(Request& request, const Limits& limits) {
    const auto certificates = request.required("requests", [&](const Json& value) {
        return read_list(value, [&](const Json& element) { return certificate_of(element, limits); });
    });
    request.finish();
    return Json::Object{{"document", coq_file(certificates, limits)}};
}

std::string render_certify(const Answered& answered) { return *answered.result().find("document")->text(); }

/// One request per line.
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
        .summary = "Answer requests as a file in which Coq checks every number",
        .documentation =
            "Coq computes each number again, from the definition of the blossom in the theorems.",
        .request = {{required(
            "requests", Shape::list(Shape::request_of(certified_names())),
            "the requests; their maps are curves, and tensor products for blossom values at "
            "given arguments")}},
        .result = {{required("document", ValueKind::text, "the file for Coq")}},
        .example = {"certify",
                    R"({"op":"blossom","map":{"kind":"polynomial","text":"1 + 2t"},"arguments":["1/2"]})"},
        .options = {{"REQUEST",
                     {"requests"},
                     "JSON",
                     "requests for agree, blossom, control-points or derivative, each on a line",
                     apply_requests}},
        .answer = answer_certify,
        .render = render_certify,
    };
}

}  // namespace blossom::protocol
