// Operations on Bezier curves: subdivision, control points over [0, 1], together and as single points, and
// degree elevation. Each row uses eight sets of operands in turn.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/curve/subdivision.hpp>

#include <memory>

#include "families.hpp"
#include "flint_curves.hpp"

namespace {

using namespace blossom;

constexpr std::size_t operand_sets = 8;

Case operands(std::size_t degree, std::size_t bits, std::size_t set) {
    std::mt19937_64 random(degree * 100000 + bits * 100 + set);
    Case result{degree, bits, {}, {}};
    for (std::size_t k = 0; k <= degree; ++k) result.coefficients.push_back(number(random, bits));
    result.arguments.push_back(number(random, bits));
    return result;
}

/// Applies the same function to the sets of operands in turn.
template <class Work>
class Turns {
public:
    Turns(std::size_t degree, std::size_t bits) {
        for (std::size_t set = 0; set < operand_sets; ++set)
            works_.push_back(std::make_unique<Work>(operands(degree, bits, set)));
    }
    void run() {
        works_[at_]->run();
        at_ = (at_ + 1) % operand_sets;
    }
    std::string text() {
        std::string all;
        for (const auto& work : works_) {
            work->run();
            all += work->text() + "\n";
        }
        return all;
    }

private:
    std::vector<std::unique_ptr<Work>> works_;
    std::size_t at_ = 0;
};

std::string text_of(PointArray points) {
    points.make_canonical();
    std::string result;
    for (const Integer& numerator : points.numbers().numerators()) result += to_string(numerator) + " ";
    return result + "/ " + to_string(points.denominator());
}

class Subdivision {
public:
    explicit Subdivision(const Case& given)
        : curve_(curve_of(given).coefficients(), Interval()), t_(given.arguments[0]) {}
    void run() { halves_ = subdivide(curve_, t_); }
    std::string text() const {
        return text_of(halves_->first.control_points()) + "; " + text_of(halves_->second.control_points());
    }

private:
    BezierCurve curve_;
    Parameter t_;
    std::optional<std::pair<BezierCurve, BezierCurve>> halves_;
};

class ControlPoints {
public:
    explicit ControlPoints(const Case& given) : curve_(curve_of(given)) {}
    void run() { polygon_ = control_points(curve_, Interval()); }
    std::string text() const { return text_of(polygon_->control_points()); }

private:
    PolynomialCurve curve_;
    std::optional<BezierCurve> polygon_;
};

class Points {
public:
    explicit Points(const Case& given) : curve_(curve_of(given)) {}
    void run() { points_ = control_points(curve_, Interval()).control_points().to_points(); }
    std::string text() const {
        std::string result;
        for (const Coordinates& point : points_) result += to_string(point.front()) + " ";
        return result;
    }

private:
    PolynomialCurve curve_;
    std::vector<Coordinates> points_;
};

class Elevation {
public:
    explicit Elevation(const Case& given) : curve_(curve_of(given).coefficients(), Interval()) {}
    void run() { raised_ = elevate(curve_, curve_.degree()); }
    std::string text() const { return text_of(raised_->control_points()); }

private:
    BezierCurve curve_;
    std::optional<BezierCurve> raised_;
};

class OneValue {
public:
    explicit OneValue(const Case& given)
        : curve_(curve_of(given)), arguments_(curve_.degree(), Parameter(given.arguments[0])) {
        for (std::size_t i = 0; i < arguments_.size(); ++i) arguments_[i] = Parameter(given.coefficients[i]);
    }
    void run() { value_ = blossom_value(curve_, arguments_); }
    std::string text() const { return to_string(value_.front()); }

private:
    PolynomialCurve curve_;
    std::vector<Argument> arguments_;
    Coordinates value_;
};

template <class Work, class Peer>
void compare(const Report& report, const char* work, std::initializer_list<std::size_t> degrees) {
    constexpr std::size_t bits = 7;
    for (const std::size_t degree : degrees) {
        if ((report.quick() && degree > 100) || !report.wants(work, degree, bits)) continue;
        Turns<Work> ours(degree, bits);
        Turns<Peer> theirs(degree, bits);
        report.compare("curves", work, degree, bits,
                       {{"engine", [&] { ours.run(); }, [&] { return ours.text(); }},
                        {"FLINT", [&] { theirs.run(); }, [&] { return theirs.text(); }}});
    }
}

}  // namespace

void measure_curves(const Report& report) {
    compare<Subdivision, flint_peer::Subdivision>(report, "subdivision", {3, 10, 20, 40, 100, 300, 800});
    compare<ControlPoints, flint_peer::ControlPoints>(report, "control points over [0 1]",
                                                      {3, 5, 10, 20, 40, 60, 100});
    compare<Points, flint_peer::Points>(report, "points over [0 1]", {3, 10, 20, 40, 100, 300});
    compare<Elevation, flint_peer::Elevation>(report, "elevation by the degree", {3, 10, 20, 40, 100, 300});
    compare<OneValue, flint_peer::OneValue>(report, "one-shot with turns",
                                            {3, 10, 20, 40, 100, 300, 1000, 4096, 10000});
}
