#include "app/figures/loop_curves.h"

#include <QtCore/QCoreApplication>

#include <array>

namespace halbench::app {
namespace {

using widgets::CurveStyle;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::TuningFigures)
};

} // namespace

std::vector<LoopCurve> loopCurves(const AnalysisResult& predicted,
                                  const std::optional<AnalysisResult>& present,
                                  const std::vector<NamedLoop>& others) {
    constexpr std::array Colours = {0, 1, 2, 3, 4, 5, 7}; // of the theme, without MarkColour
    const bool isAlone = !present && others.empty();
    std::vector<LoopCurve> curves;
    curves.push_back(
        {&predicted, isAlone ? std::string() : Words::tr("proposed").toStdString(), CurveStyle::Line, 0});
    if (present) {
        curves.push_back({&*present, Words::tr("before").toStdString(), CurveStyle::DashedLine, 1});
    }
    for (const NamedLoop& other : others) {
        const std::size_t at = curves.size();
        curves.push_back({other.loop, other.name,
                          at < Colours.size() ? CurveStyle::Line : CurveStyle::DottedLine,
                          Colours[at % Colours.size()]});
    }
    return curves;
}

widgets::Curve bandCurve(const std::vector<double>& x, const control::Band& band, double xScale,
                         double yScale) {
    widgets::Curve curve{
        Words::tr("5-95 % band (motor uncertainty)").toStdString(), {}, {}, CurveStyle::Band, 0};
    for (std::size_t i = 0; i < x.size(); ++i) {
        curve.x.push_back(xScale * x[i]);
        curve.y.push_back(yScale * band.p95[i]);
    }
    for (std::size_t i = x.size(); i-- > 0;) { // and back along the lower edge
        curve.x.push_back(xScale * x[i]);
        curve.y.push_back(yScale * band.p5[i]);
    }
    return curve;
}

} // namespace halbench::app
