#include "tests/gui/inspection.h"

#include "tests/gui/needless_cuts.h"
#include "tests/gui/seen_text.h"
#include "tests/gui/word_contrast.h"
#include "tests/gui/word_room.h"
#include "widgets/theme/theme_style.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QTabBar>
#include <QToolButton>
#include <QXmlStreamReader>

#include <algorithm>
#include <vector>

namespace halbench::gui {

namespace {

/// WCAG 2.1, level AA, for words of ordinary size.
constexpr double LeastContrast = 4.5;
/// Letters of an English text that cannot be there by chance.
constexpr int TellingPart = 10;

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

/// Of a control that a key works as well; an access key is underlined in its words.
QString untoldKey(const QWidget& widget) {
    QList<QKeySequence> keys;
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        if (button->shortcut() != QKeySequence::mnemonic(button->text())) {
            keys << button->shortcut();
        }
    }
    if (const auto* tool = qobject_cast<const QToolButton*>(&widget);
        tool != nullptr && tool->defaultAction() != nullptr) {
        keys << tool->defaultAction()->shortcut();
    }
    for (const QKeySequence& key : keys) {
        const bool isTold = widget.toolTip().contains(key.toString()) ||
                            widget.toolTip().contains(key.toString(QKeySequence::NativeText));
        if (!key.isEmpty() && !isTold) {
            return QStringLiteral("tooltip '%1' does not name its key %2")
                .arg(widget.toolTip(), key.toString());
        }
    }
    return {};
}

bool isControl(const QWidget& widget) {
    const bool isPart = qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) != nullptr ||
                        qobject_cast<const QComboBox*>(widget.parentWidget()) != nullptr ||
                        qobject_cast<const QTabBar*>(widget.parentWidget()) != nullptr || // its arrows
                        widget.inherits("QTableCornerButton"); // Ctrl+A of the table
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

/// Which words are too faint to read there; empty: none.
QString faint(QWidget& widget, const QString& text, const QRect& place) {
    const double contrast_ratio = faintestWord_ratio(widget, place);
    return contrast_ratio < LeastContrast
               ? QStringLiteral("'%1' has a contrast of %2").arg(text).arg(contrast_ratio, 0, 'f', 1)
               : QString();
}

QStringList inspectParts(QWidget& widget, const QHash<QString, QString>& phrases) {
    QStringList found;
    for (const SeenWords& words : seenWords(widget)) {
        found << foreign(words.text, phrases) << faint(widget, words.text, words.place);
    }
    return found;
}

QStringList inspectOne(QWidget& widget, const QHash<QString, QString>& phrases) {
    QStringList found;
    found << lackOfRoom(widget) << needlessCuts(widget) << untoldKey(widget);
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
        found << faint(widget, textOf(widget), wordsPlace(widget));
    }
    found << inspectParts(widget, phrases);
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
