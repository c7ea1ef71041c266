#include "app/report/loop_curves.h"

#include <QtCore/QCoreApplication>

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
    constexpr int Colours = 8; // of the theme
    const bool isAlone = !present && others.empty();
    std::vector<LoopCurve> curves;
    curves.push_back(
        {&predicted, isAlone ? std::string() : Words::tr("proposed").toStdString(), CurveStyle::Line, 0});
    if (present) {
        curves.push_back({&*present, Words::tr("before").toStdString(), CurveStyle::DashedLine, 1});
    }
    for (const NamedLoop& other : others) {
        const int at = static_cast<int>(curves.size());
        curves.push_back(
            {other.loop, other.name, at < Colours ? CurveStyle::Line : CurveStyle::DottedLine, at % Colours});
    }
    return curves;
}

} // namespace halbench::app
