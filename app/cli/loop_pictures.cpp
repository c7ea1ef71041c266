#include "app/cli/loop_pictures.h"

#include "app/documents/text/output_file.h"
#include "app/figures/axis_figures.h"
#include "app/figures/disturbance_figure.h"
#include "app/figures/loop_figures.h"
#include "app/figures/picture_file.h"
#include "app/figures/recording_picture.h"
#include "app/figures/root_locus_figure.h"
#include "app/figures/tuning_figures.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

/// Of the one view that takes tenths of a second and more, only when it is drawn.
void addLargeStep(LoopUncertainty& uncertainty, const DrawnLoop& loop) {
    const TuneResult& result = *loop.result;
    const std::optional<LargeStep>& step = result.predicted.largeStep;
    if (!step) {
        return;
    }
    auto band = largeStepBand(*loop.motor, {result.law, result.filtered}, result.conditions,
                              {step->amplitude_rad, step->duration_s()}, loop.draws);
    if (band) {
        uncertainty.largeStep = *std::move(band);
    }
}

std::optional<widgets::Figure> figureOf(const std::string& view, const DrawnLoop& loop,
                                        const std::optional<LoopUncertainty>& uncertainty) {
    const TuneResult& result = *loop.result;
    const AnalysisResult& predicted = result.predicted;
    if (view == "bode") {
        return openLoopFigure(predicted, {}, loop.others, {}, uncertainty);
    }
    if (view == "nyquist") {
        return nyquistFigure(predicted, {}, loop.others);
    }
    if (view == "nichols") {
        return nicholsFigure(predicted, {}, loop.others);
    }
    if (view == "sensitivity") {
        return sensitivityFigure(predicted, {}, loop.others);
    }
    if (view == "root-locus") {
        return rootLocusFigure(predicted, {}, loop.others);
    }
    if (view == "step" && result.conditions.axis) {
        return axisStepFigure(*result.conditions.axis, predicted, {});
    }
    if (view == "step") {
        return linearStepFigure(predicted, {}, widgets::AngleUnit::Radian, loop.others, uncertainty);
    }
    if (view == "large-step") {
        return largeStepFigure(predicted, {}, widgets::AngleUnit::Degree, loop.others, uncertainty);
    }
    const auto& disturbance = result.disturbance;
    return disturbance ? disturbanceFigure(disturbance->step, {}, widgets::AngleUnit::Degree,
                                           disturbance->load_A, disturbance->band)
                       : std::nullopt;
}

} // namespace

const std::vector<std::string>& loopViews() {
    static const std::vector<std::string> views = {"bode",       "nyquist", "nichols",    "sensitivity",
                                                   "root-locus", "step",    "large-step", "disturbance"};
    return views;
}

Result<std::vector<LoopPicture>> loopPicturesOf(const std::vector<std::string>& options) {
    std::vector<LoopPicture> pictures;
    for (const std::string& option : options) {
        const std::size_t sign = option.find('=');
        LoopPicture picture{option.substr(0, sign),
                            sign == std::string::npos ? std::string() : option.substr(sign + 1)};
        const auto& views = loopViews();
        if (picture.path.empty() || std::find(views.begin(), views.end(), picture.view) == views.end()) {
            return failure(ErrorCode::Usage, fmt::format("--picture: '{}' is no VIEW=FILE", option),
                           fmt::format("VIEW is {}", fmt::join(views, ", ")));
        }
        if (!isPictureFile(picture.path)) {
            return failure(ErrorCode::Usage,
                           fmt::format("'{}' is of no format of pictures that can be written", picture.path),
                           "this version writes .svg, .pdf and .png");
        }
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

Result<void> writeLoopPictures(const std::vector<LoopPicture>& pictures, const DrawnLoop& loop) {
    if (pictures.empty()) {
        return {};
    }
    std::optional<LoopUncertainty> uncertainty;
    if (auto known = loopUncertainty(*loop.motor, {loop.result->law, loop.result->filtered},
                                     loop.result->conditions, loop.result->predicted, loop.draws)) {
        uncertainty = *std::move(known);
    }
    for (const LoopPicture& picture : pictures) {
        if (picture.view == "large-step" && uncertainty) {
            addLargeStep(*uncertainty, loop);
        }
        const auto figure = figureOf(picture.view, loop, uncertainty);
        if (!figure || figure->panels.empty()) {
            return failure(ErrorCode::Refused,
                           fmt::format("--picture {}: the loop is unstable and has none", picture.view),
                           "draw its bode, nyquist, nichols or root-locus");
        }
        const Result<std::string> content = figurePicture(*figure, picture.path);
        const Result<void> written =
            content ? writeFile(picture.path, *content) : Result<void>(failure(content.error()));
        if (!written) {
            return written;
        }
    }
    return {};
}

} // namespace halbench::app
