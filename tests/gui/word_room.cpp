#include "tests/gui/word_room.h"

#include "widgets/theme/theme_style.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

#include <algorithm>

namespace halbench::gui {

namespace {

/// A character's advance is rounded to whole pixels by some of Qt's layouts and not by others.
constexpr int Rounding_px = 2;
/// Border and padding of the sheet, on each side.
constexpr int PushButtonEdge_px = 10;

int wordWidth_px(const QWidget& widget, const QString& text) {
    return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

/// The room of the words in a control; what the style takes for frame, icon and arrow is not theirs.
int room_px(const QWidget& widget) {
    QStyleOption option;
    option.initFrom(&widget);
    const QStyle& style = *widget.style();
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox box;
        box.initFrom(combo);
        box.editable = combo->isEditable();
        return style.subControlRect(QStyle::CC_ComboBox, &box, QStyle::SC_ComboBoxEditField, combo).width();
    }
    if (qobject_cast<const QPushButton*>(&widget) != nullptr) {
        return widget.width() - 2 * PushButtonEdge_px;
    }
    if (const auto* tool = qobject_cast<const QToolButton*>(&widget)) {
        const int icon_px =
            tool->toolButtonStyle() == Qt::ToolButtonTextBesideIcon ? tool->iconSize().width() : 0;
        return tool->width() - icon_px - 2 * widgets::GridStep_px;
    }
    if (widget.inherits("QCheckBox")) {
        return style.subElementRect(QStyle::SE_CheckBoxContents, &option, &widget).width();
    }
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) {
        return box->width() - 2 * widgets::GridStep_px;
    }
    return widget.contentsRect().width();
}

/// Labels that leave out what does not fit do so on purpose, and their tooltip has all of it.
QString cutWords(const QLabel& label) {
    const bool isElided = label.text().endsWith(QChar(0x2026));
    const QString shown = plain(label.text()).chopped(isElided ? 1 : 0).trimmed();
    const bool isMeant =
        label.inherits("halbench::widgets::ElidedLabel") || label.inherits("ads::CElidingLabel");
    return isElided && isMeant && !plain(label.toolTip()).contains(shown)
               ? QStringLiteral("'%1' is cut and no tooltip has it all").arg(label.text())
               : QString();
}

QString tooWide(const QWidget& widget) {
    const QString text = textOf(widget);
    if (text.isEmpty()) {
        return {};
    }
    const auto* label = qobject_cast<const QLabel*>(&widget);
    if (label != nullptr && label->wordWrap()) {
        const int needed_px = label->heightForWidth(label->width());
        return needed_px > label->height() + Rounding_px
                   ? QStringLiteral("'%1' needs %2 px of height, has %3")
                         .arg(text)
                         .arg(needed_px)
                         .arg(label->height())
                   : QString();
    }
    const auto* combo = qobject_cast<const QComboBox*>(&widget);
    if (combo != nullptr && combo->toolTip().contains(text) &&
        combo->sizeAdjustPolicy() == QComboBox::AdjustToMinimumContentsLengthWithIcon) {
        return {}; // narrower than its longest choice on purpose, and the tooltip has this one
    }
    const int needed_px = label != nullptr && Qt::mightBeRichText(text) ? label->sizeHint().width()
                                                                        : wordWidth_px(widget, text);
    return needed_px > room_px(widget) + Rounding_px
               ? QStringLiteral("'%1' needs %2 px, has %3").arg(text).arg(needed_px).arg(room_px(widget))
               : QString();
}

QStringList narrowSections(const QHeaderView& header) {
    QStringList found;
    for (int section = 0; section < header.count(); ++section) {
        const QString text = header.model()->headerData(section, header.orientation()).toString();
        const int needed_px = wordWidth_px(header, text) + 2 * widgets::GridStep_px;
        if (header.orientation() == Qt::Horizontal && !header.isSectionHidden(section) &&
            needed_px > header.sectionSize(section)) {
            found << QStringLiteral("header '%1' needs %2 px, has %3")
                         .arg(text)
                         .arg(needed_px)
                         .arg(header.sectionSize(section));
        }
    }
    return found;
}

QStringList narrowTabs(const QTabBar& bar) {
    QStringList found;
    for (int tab = 0; tab < bar.count(); ++tab) {
        const int needed_px = wordWidth_px(bar, bar.tabText(tab));
        if (bar.isTabVisible(tab) && needed_px > bar.tabRect(tab).width() + Rounding_px) {
            found << QStringLiteral("tab '%1' needs %2 px, has %3")
                         .arg(bar.tabText(tab))
                         .arg(needed_px)
                         .arg(bar.tabRect(tab).width());
        }
    }
    return found;
}

} // namespace

QString plain(const QString& text) {
    QString words = text;
    if (Qt::mightBeRichText(words)) {
        QTextDocument document;
        document.setHtml(words);
        words = document.toPlainText();
    }
    return words.remove(QRegularExpression(QStringLiteral("\\(&.\\)|&(?!&)")));
}

QString textOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return label->text();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        const bool isIcon =
            tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
        return isIcon ? QString() : button->text();
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
        return combo->currentText();
    }
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) {
        return box->title();
    }
    return {};
}

/// Where the words are, without frame, icon and mark.
QRect wordsPlace(const QWidget& widget) {
    QStyleOption option;
    option.initFrom(&widget);
    constexpr int Frame_px = 4;
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox box;
        box.initFrom(combo);
        return widget.style()->subControlRect(QStyle::CC_ComboBox, &box, QStyle::SC_ComboBoxEditField, combo);
    }
    if (widget.inherits("QCheckBox")) {
        return widget.style()->subElementRect(QStyle::SE_CheckBoxContents, &option, &widget);
    }
    if (widget.inherits("QRadioButton")) {
        return widget.style()->subElementRect(QStyle::SE_RadioButtonContents, &option, &widget);
    }
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) {
        return {widgets::GridStep_px, 0, wordWidth_px(widget, box->title()), widget.fontMetrics().height()};
    }
    QRect place = widget.contentsRect();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        place.adjust(Frame_px, Frame_px, -Frame_px, -Frame_px);
        if (const auto* tool = qobject_cast<const QToolButton*>(button)) {
            const bool hasIcon = tool->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
            const bool hasArrow = tool->popupMode() == QToolButton::MenuButtonPopup;
            const int arrow_px = widget.style()->pixelMetric(QStyle::PM_MenuButtonIndicator, nullptr, tool);
            place.adjust(hasIcon ? tool->iconSize().width() + Frame_px : 0, 0,
                         hasArrow ? -arrow_px - Frame_px : 0, 0);
        } else if (!button->icon().isNull()) { // icon and words stand in the middle together
            const int words_px = wordWidth_px(widget, button->text());
            const int all_px = button->iconSize().width() + Frame_px + words_px;
            place.setLeft(std::max(place.left(), place.center().x() + all_px / 2 - words_px));
        }
    }
    return place;
}

QStringList lackOfRoom(const QWidget& widget) {
    QStringList found{tooWide(widget)};
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        found << cutWords(*label);
    }
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) {
        found << narrowSections(*header);
    }
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
        found << narrowTabs(*bar);
    }
    return found;
}

} // namespace halbench::gui
