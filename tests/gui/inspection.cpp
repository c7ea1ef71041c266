#include "tests/gui/inspection.h"

#include "widgets/theme_style.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPixmap>
#include <QPushButton>
#include <QRegularExpression>
#include <QShortcut>
#include <QStyleOptionComboBox>
#include <QStyleOptionToolButton>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>
#include <QXmlStreamReader>

#include <algorithm>
#include <vector>

namespace halbench::gui {

namespace {

/// WCAG 2.1, level AA, for words of ordinary size.
constexpr double LeastContrast = 4.5;
/// A character's advance is rounded to whole pixels by some of Qt's layouts and not by others.
constexpr int Rounding_px = 2;
/// Border and padding of the sheet, on each side.
constexpr int PushButtonEdge_px = 10;
/// Letters of an English text that cannot be there by chance.
constexpr int TellingPart = 10;

QString plain(const QString& text) {
    QString words = text;
    if (Qt::mightBeRichText(words)) {
        QTextDocument document;
        document.setHtml(words);
        words = document.toPlainText();
    }
    return words.remove(QRegularExpression(QStringLiteral("\\(&.\\)|&(?!&)")));
}

/// Of a phrase into which something is filled; what a message keeps when its phrase is not translated.
QString longestPart(const QString& phrase) {
    QString longest;
    for (const QString& part : phrase.split(QStringLiteral("{}"))) {
        longest = part.size() > longest.size() ? part : longest;
    }
    return longest;
}

QString pathOf(const QWidget& widget) {
    QStringList parts;
    for (const QWidget* one = &widget; one != nullptr; one = one->parentWidget()) {
        const QString type =
            QString::fromLatin1(one->metaObject()->className()).section(QStringLiteral("::"), -1);
        if (!one->objectName().isEmpty() && !one->objectName().startsWith(QLatin1String("qt_"))) {
            parts.prepend(type + QLatin1Char('#') + one->objectName());
        } else if (one == &widget || one->isWindow()) {
            parts.prepend(type);
        }
    }
    return parts.join(QLatin1Char('/'));
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
    return {};
}

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
    return widget.contentsRect().width();
}

bool isTold(const QWidget& widget, const QString& text) {
    return plain(widget.toolTip()).contains(plain(text));
}

QString tooWide(const QWidget& widget) {
    const QString text = textOf(widget);
    if (text.isEmpty() || isTold(widget, text)) {
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
        const QString told =
            header.model()->headerData(section, header.orientation(), Qt::ToolTipRole).toString();
        const int needed_px = wordWidth_px(header, text) + 2 * widgets::GridStep_px;
        if (header.orientation() == Qt::Horizontal && !header.isSectionHidden(section) &&
            !told.contains(text) && needed_px > header.sectionSize(section)) {
            found << QStringLiteral("header '%1' needs %2 px, has %3")
                         .arg(text)
                         .arg(needed_px)
                         .arg(header.sectionSize(section));
        }
    }
    return found;
}

bool isControl(const QWidget& widget) {
    const bool isPart = qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) != nullptr ||
                        qobject_cast<const QComboBox*>(widget.parentWidget()) != nullptr ||
                        qobject_cast<const QTabBar*>(widget.parentWidget()) != nullptr; // its arrows
    return !isPart && (qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
                       qobject_cast<const QComboBox*>(&widget) != nullptr ||
                       qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
                       qobject_cast<const QLineEdit*>(&widget) != nullptr);
}

bool takesFocus(const QWidget& widget) {
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.focusProxy() == nullptr &&
           qobject_cast<const QComboBox*>(widget.parentWidget()) == nullptr &&
           qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) == nullptr;
}

QString nameOf(QWidget& widget) {
    QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&widget);
    return face == nullptr ? QString() : face->text(QAccessible::Name);
}

/// A whole phrase, or the English of one within a longer text.
QString foreign(const QString& text, const QHash<QString, QString>& phrases) {
    const QString words = plain(text);
    const auto isLeft = [&](auto one) {
        return one.key().size() >= TellingPart && one.key().count(QLatin1Char(' ')) >= 2 &&
               words.contains(one.key()) && !one->contains(one.key());
    };
    bool isForeign = phrases.contains(words);
    for (auto one = phrases.begin(); one != phrases.end() && !isForeign; ++one) {
        isForeign = isLeft(one);
    }
    return isForeign ? QStringLiteral("'%1' is not translated").arg(words) : QString();
}

/// What the eye sees: the commonest colour is the background, the one that differs most from it the words.
double shownContrast_ratio(QWidget& widget) {
    const QRect place(widget.mapTo(widget.window(), QPoint()), widget.size());
    const QImage image = widget.window()->grab(place).toImage().convertToFormat(QImage::Format_RGB32);
    QHash<QRgb, int> counts;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            ++counts[image.pixel(x, y)];
        }
    }
    const auto commonest = std::max_element(counts.begin(), counts.end());
    double largest_ratio = 1.0;
    for (auto one = counts.begin(); one != counts.end(); ++one) {
        largest_ratio =
            std::max(largest_ratio, widgets::contrastRatio(QColor(one.key()), QColor(commonest.key())));
    }
    return largest_ratio;
}

QStringList inspectOne(QWidget& widget, const QHash<QString, QString>& phrases) {
    QStringList found;
    found << tooWide(widget);
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) {
        found << narrowSections(*header);
    }
    if (takesFocus(widget) && nameOf(widget).isEmpty()) {
        found << QStringLiteral("has no accessible name");
    }
    if (isControl(widget) && widget.toolTip().isEmpty()) {
        found << QStringLiteral("has no tooltip");
    }
    for (const QString& text : {textOf(widget), widget.toolTip(), widget.accessibleName()}) {
        found << foreign(text, phrases);
    }
    const bool hasWords = !plain(textOf(widget)).trimmed().isEmpty();
    const bool isWhole = widget.visibleRegion() == QRegion(widget.rect()); // not scrolled out of sight
    if (hasWords && isWhole && widget.isEnabled() && !widget.size().isEmpty()) {
        const double contrast_ratio = shownContrast_ratio(widget);
        if (contrast_ratio < LeastContrast) {
            found << QStringLiteral("'%1' has a contrast of %2")
                         .arg(textOf(widget))
                         .arg(contrast_ratio, 0, 'f', 1);
        }
    }
    found.removeAll({});
    found.removeDuplicates();
    return found;
}

struct KeyUser {
    QKeySequence key;
    QString name;
    const QWidget* place = nullptr; ///< the key works while the focus is in it; null: everywhere
};

void add(std::vector<KeyUser>& users, const QKeySequence& key, const QString& name, const QWidget* place) {
    if (!key.isEmpty()) {
        users.push_back({key, name, place});
    }
}

void addAction(std::vector<KeyUser>& users, const QAction& action) {
    const bool isLocal = action.shortcutContext() == Qt::WidgetShortcut ||
                         action.shortcutContext() == Qt::WidgetWithChildrenShortcut;
    const QWidget* place = isLocal ? action.parentWidget() : nullptr;
    if (place == nullptr || place->isVisible()) {
        for (const QKeySequence& key : action.shortcuts()) {
            add(users, key, action.text(), place);
        }
    }
}

std::vector<KeyUser> keyUsers(const QWidget& window) {
    std::vector<KeyUser> users;
    for (const auto* bar : window.findChildren<QMenuBar*>()) {
        for (const QAction* title : bar->actions()) {
            add(users, QKeySequence::mnemonic(title->text()), title->text(), nullptr);
        }
    }
    for (const auto* action : window.findChildren<QAction*>()) {
        addAction(users, *action);
    }
    for (const auto* shortcut : window.findChildren<QShortcut*>()) {
        const bool isLocal = shortcut->context() == Qt::WidgetWithChildrenShortcut;
        if (shortcut->parentWidget()->isVisible()) {
            add(users, shortcut->key(), pathOf(*shortcut->parentWidget()),
                isLocal ? shortcut->parentWidget() : nullptr);
        }
    }
    for (const auto* button : window.findChildren<QAbstractButton*>()) {
        if (button->isVisible()) {
            add(users, button->shortcut(), button->text(), nullptr);
        }
    }
    for (const auto* label : window.findChildren<QLabel*>()) {
        if (label->isVisible() && label->buddy() != nullptr) {
            add(users, QKeySequence::mnemonic(label->text()), label->text(), nullptr);
        }
    }
    return users;
}

} // namespace

QHash<QString, QString> phrasesOf(const QString& language) {
    QHash<QString, QString> phrases;
    QStringList translations;
    QFile file(QStringLiteral(HALBENCH_TRANSLATIONS "/halbench_%1.ts").arg(language));
    if (language == QLatin1String("en") || !file.open(QIODevice::ReadOnly)) {
        return phrases;
    }
    QXmlStreamReader reader(&file);
    QString source;
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement() && reader.name() == QLatin1String("source")) {
            source = reader.readElementText();
        } else if (reader.isStartElement() && reader.name() == QLatin1String("translation")) {
            translations << plain(reader.readElementText(QXmlStreamReader::IncludeChildElements));
            phrases.insert(longestPart(plain(source)), translations.last());
        }
    }
    for (const QString& translation : translations) { // a word that is right in this language as well
        phrases.remove(translation);
    }
    return phrases;
}

QStringList inspect(const QWidget& root, const QHash<QString, QString>& phrases) {
    QStringList found;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        if (widget->isVisible() && qobject_cast<QMenu*>(widget) == nullptr) {
            for (const QString& finding : inspectOne(*widget, phrases)) {
                found << pathOf(*widget) + QStringLiteral(": ") + finding;
            }
        }
    }
    return found;
}

QStringList inspectKeys(const QWidget& window) {
    QStringList found;
    const std::vector<KeyUser> users = keyUsers(window);
    for (auto one = users.begin(); one != users.end(); ++one) {
        for (auto other = one + 1; other != users.end(); ++other) {
            const bool meet = one->place == other->place || one->place == nullptr || other->place == nullptr;
            if (one->key == other->key && meet) {
                found << QStringLiteral("'%1' and '%2' share %3")
                             .arg(one->name, other->name, one->key.toString());
            }
        }
    }
    return found;
}

QStringList inspectMenu(const QMenu& menu, const QHash<QString, QString>& phrases) {
    QStringList found;
    QHash<QString, QString> keys;
    for (const QAction* action : menu.actions()) {
        const QString text = action->text();
        const QString key = QKeySequence::mnemonic(text).toString();
        if (!key.isEmpty() && keys.contains(key)) {
            found << QStringLiteral("menu '%1': '%2' and '%3' share %4")
                         .arg(menu.title(), keys[key], text, key);
        }
        keys.insert(key, text);
        found << foreign(text, phrases);
        if (action->menu() != nullptr) {
            found << inspectMenu(*action->menu(), phrases);
        }
    }
    found.removeAll({});
    return found;
}

} // namespace halbench::gui
