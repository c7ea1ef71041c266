#pragma once

#include "app/workspaces/tune/loop/gain_history.h"

#include <QAction>
#include <QList>
#include <QObject>

namespace halbench::app {

/// Undo and redo of changes to the proposed gains as two actions, named after the change. Their shortcuts
/// work within the widgets they are added to: other panels have histories of their own. Thread: GUI.
class GainHistoryActions : public QObject {
    Q_OBJECT
public:
    explicit GainHistoryActions(QObject* parent = nullptr);

    /// As of GainHistory.
    void restart(GainChoice now);
    void record(const QString& what, const QString& key, GainChoice now);
    void refreshTexts();
    QAction& undo() { return m_undo; }
    QAction& redo() { return m_redo; }

Q_SIGNALS:
    void chosen(const halbench::app::GainChoice& choice); ///< the gains come from there again

private:
    GainHistory m_history;
    QAction m_undo;
    QAction m_redo;
};

} // namespace halbench::app
