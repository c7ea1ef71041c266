#include "widgets/theme/theme_proxy.h"

#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QPainter>
#include <QPainterPath>
#include <QStyleFactory>
#include <QStyleOption>
#include <QStyledItemDelegate>

namespace halbench::widgets {
namespace {

constexpr double CornerRadius_px = 4.0;
constexpr double RingWidth_px = 2.0;
constexpr int OverflowWidth_px = 26;

} // namespace

ThemeProxy::ThemeProxy(const Theme& theme)
    : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))), m_theme(theme) {}

/// The list of a combo box has Qt's old delegate, which no style sheet reaches: rows as high as the letters.
void ThemeProxy::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    auto* box = qobject_cast<QComboBox*>(widget);
    if (box != nullptr && qobject_cast<QStyledItemDelegate*>(box->itemDelegate()) == nullptr) {
        box->setItemDelegate(new QStyledItemDelegate(box));
    }
}

void ThemeProxy::drawBox(const QRect& box, const QStyleOption& option, QPainter& painter) const {
    const bool isEnabled = option.state.testFlag(State_Enabled);
    const bool hasFocus = option.state.testFlag(State_HasFocus) && isEnabled;
    const bool isHovered = option.state.testFlag(State_MouseOver) && isEnabled;
    const double width = hasFocus ? RingWidth_px : 1.0;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(isEnabled ? m_theme.panel : m_theme.window);
    painter.setPen(QPen(hasFocus ? m_theme.accent : isHovered ? m_theme.muted : m_theme.line, width));
    const double inset = width / 2.0;
    painter.drawRoundedRect(QRectF(box).adjusted(inset, inset, -inset, -inset), CornerRadius_px,
                            CornerRadius_px);
}

void ThemeProxy::drawChevron(const QRect& box, bool isUp, bool isEnabled, QPainter& painter) const {
    const QPointF centre = QRectF(box).center();
    const double half = qMin(3.5, box.height() / 4.0);
    const double tip = isUp ? -half / 2.0 : half / 2.0;
    QPainterPath path(centre + QPointF(-half, -tip));
    path.lineTo(centre + QPointF(0.0, tip));
    path.lineTo(centre + QPointF(half, -tip));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(isEnabled ? m_theme.muted : m_theme.disabled, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

void ThemeProxy::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    if (element == PE_FrameFocusRect) {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(m_theme.accent, RingWidth_px));
        painter->drawRoundedRect(QRectF(option->rect).adjusted(1.0, 1.0, -1.0, -1.0), 2.0, 2.0);
        painter->restore();
        return;
    }
    if (element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck ||
        element == PE_IndicatorRadioButton) {
        painter->save();
        drawIndicator(element, *option, *painter);
        painter->restore();
        return;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void ThemeProxy::drawIndicator(PrimitiveElement element, const QStyleOption& option,
                               QPainter& painter) const {
    const bool isEnabled = option.state.testFlag(State_Enabled);
    const bool isOn = option.state.testFlag(State_On);
    const bool isHalf = option.state.testFlag(State_NoChange);
    const QColor filled = isEnabled ? m_theme.accent : m_theme.disabled;
    const double side = qMin(option.rect.width(), option.rect.height()) - 1.0;
    QRectF box(0.0, 0.0, side, side);
    box.moveCenter(QRectF(option.rect).center());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(isOn || isHalf ? filled : isEnabled ? m_theme.muted : m_theme.disabled, 1.0));
    if (element == PE_IndicatorRadioButton) {
        painter.setBrush(m_theme.panel);
        painter.drawEllipse(box);
        if (isOn) {
            painter.setBrush(filled);
            painter.drawEllipse(box.center(), side / 4.0, side / 4.0);
        }
        return;
    }
    painter.setBrush(isOn || isHalf ? filled : m_theme.panel);
    painter.drawRoundedRect(box, 2.0, 2.0);
    const auto at = [&box](double x, double y) {
        return QPointF(box.x() + x * box.width(), box.y() + y * box.height());
    };
    painter.setPen(QPen(readableOn(m_theme, filled), 1.75, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (isOn) {
        painter.drawPolyline(QPolygonF({at(0.24, 0.52), at(0.43, 0.71), at(0.77, 0.31)}));
    } else if (isHalf) {
        painter.drawLine(at(0.25, 0.5), at(0.75, 0.5));
    }
}

void ThemeProxy::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                    QPainter* painter, const QWidget* widget) const {
    const bool isEnabled = option->state.testFlag(State_Enabled);
    painter->save();
    if (control == CC_ComboBox) {
        drawBox(option->rect, *option, *painter);
        drawChevron(subControlRect(control, option, SC_ComboBoxArrow, widget), false, isEnabled, *painter);
    } else if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
               control == CC_SpinBox && spin != nullptr) {
        drawBox(option->rect, *option, *painter);
        if (widget != nullptr && roleOf(*widget) == Role::Bad) {
            painter->setBrush(Qt::NoBrush);
            painter->setPen(QPen(m_theme.bad, 2.0));
            painter->drawRoundedRect(QRectF(option->rect).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
        }
        if (spin->buttonSymbols != QAbstractSpinBox::NoButtons) {
            drawChevron(subControlRect(control, option, SC_SpinBoxUp, widget), true,
                        isEnabled && spin->stepEnabled.testFlag(QAbstractSpinBox::StepUpEnabled), *painter);
            drawChevron(subControlRect(control, option, SC_SpinBoxDown, widget), false,
                        isEnabled && spin->stepEnabled.testFlag(QAbstractSpinBox::StepDownEnabled), *painter);
        }
    } else {
        painter->restore();
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        return;
    }
    painter->restore();
}

QSize ThemeProxy::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const {
    QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (type == CT_ComboBox || type == CT_SpinBox) {
        // The same height as buttons and line edits of the style sheet.
        result.setHeight(qMax(result.height(), option->fontMetrics.height() + 11));
    }
    return result;
}

/// Fusion's button for what a tool bar has no room for is 12 pixels wide and its frame leaves no room in it.
int ThemeProxy::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    return metric == PM_ToolBarExtensionExtent ? OverflowWidth_px
                                               : QProxyStyle::pixelMetric(metric, option, widget);
}

QIcon ThemeProxy::standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const {
    return icon == SP_ToolBarHorizontalExtensionButton ? themedIcon(QStringLiteral("chevron-down"))
                                                       : QProxyStyle::standardIcon(icon, option, widget);
}

int ThemeProxy::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* result) const {
    if (hint == SH_ComboBox_Popup) {
        return 0; // a list below the box, not a menu over it
    }
    return QProxyStyle::styleHint(hint, option, widget, result);
}

} // namespace halbench::widgets
