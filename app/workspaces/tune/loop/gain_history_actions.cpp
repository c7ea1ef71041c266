#include "app/workspaces/tune/loop/gain_history_actions.h"

#include "widgets/theme/icons.h"

#include <utility>

namespace halbench::app {

GainHistoryActions::GainHistoryActions(QObject* parent) : QObject(parent) {
    const auto prepare = [](QAction& action, const char* icon, const char* key) {
        action.setIcon(widgets::themedIcon(QLatin1String(icon)));
        action.setShortcut(QKeySequence(QLatin1String(key)));
        action.setShortcutContext(Qt::WidgetWithChildrenShortcut);
    };
    prepare(m_undo, "undo", "Ctrl+Z");
    prepare(m_redo, "redo", "Ctrl+Shift+Z");
    connect(&m_undo, &QAction::triggered, this, [this] {
        const GainChoice choice = m_history.undo();
        refreshTexts();
        Q_EMIT chosen(choice);
    });
    connect(&m_redo, &QAction::triggered, this, [this] {
        const GainChoice choice = m_history.redo();
        refreshTexts();
        Q_EMIT chosen(choice);
    });
    refreshTexts();
}

void GainHistoryActions::restart(GainChoice now) {
    m_history.restart(std::move(now));
    refreshTexts();
}

void GainHistoryActions::record(const QString& what, const QString& key, GainChoice now) {
    m_history.record(what, key, std::move(now));
    refreshTexts();
}

void GainHistoryActions::refreshTexts() {
    const auto say = [](QAction& action, const QString& verb, const QString& what) {
        action.setText(what.isEmpty() ? verb : QStringLiteral("%1: %2").arg(verb, what));
        action.setEnabled(!what.isEmpty());
        action.setToolTip(QStringLiteral("%1 (%2)").arg(
            action.text().remove('&'), action.shortcut().toString(QKeySequence::NativeText)));
    };
    say(m_undo, tr("&Undo"), m_history.undoName());
    say(m_redo, tr("&Redo"), m_history.redoName());
}

} // namespace halbench::app
