#pragma once

#include <QRect>

class QImage;
class QWidget;

namespace halbench::gui {

/// Contrast of the faintest word in a picture against its commonest colour: a dark word does not excuse a
/// pale one beside it. 21 where there is none. `letter_px`: what is narrower is no word, as a dot or a dash.
double faintestWord_ratio(const QImage& image, int letter_px);

/// Of the words that a widget shows in this part of it.
double faintestWord_ratio(QWidget& widget, const QRect& place);

} // namespace halbench::gui
