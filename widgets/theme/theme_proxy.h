#pragma once

#include "widgets/theme/theme.h"

#include <QProxyStyle>

namespace halbench::widgets {

/// Fusion without its gradients: flat spin and combo boxes from the theme and a focus ring one can see. What
/// the style sheet can say is said there.
class ThemeProxy : public QProxyStyle {
public:
    explicit ThemeProxy(const Theme& theme);

    using QProxyStyle::polish;
    void polish(QWidget* widget) override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                           const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override;

private:
    void drawBox(const QRect& box, const QStyleOption& option, QPainter& painter) const;
    void drawIndicator(PrimitiveElement element, const QStyleOption& option, QPainter& painter) const;
    void drawChevron(const QRect& box, bool isUp, bool isEnabled, QPainter& painter) const;

    Theme m_theme;
};

} // namespace halbench::widgets
