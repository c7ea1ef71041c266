#include "app/figures/picture_file.h"

#include "widgets/figure/figure_file.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/theme/theme.h"

#include <QString>

#include <utility>

namespace halbench::app {

Result<std::string> figurePicture(widgets::Figure figure, const std::string& path) {
    const auto application = widgets::OffscreenApplication::ensure();
    const Result<widgets::Theme> theme = widgets::loadTheme("light");
    if (!application || !theme) {
        return failure(application ? theme.error() : application.error());
    }
    if (figure.isEqualScale && !figure.panels.empty()) {
        widgets::makeEqualScale(figure, widgets::PictureWidth_px);
    }
    const auto format =
        widgets::pictureFormat(QString::fromStdString(path)).value_or(widgets::PictureFormat::Png);
    const Result<QByteArray> picture = widgets::pictureFile(figure, *theme, format);
    return picture ? Result<std::string>(picture->toStdString()) : failure(picture.error());
}

} // namespace halbench::app
