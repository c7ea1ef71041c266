#pragma once

#include "app/workbench/workbench.h"

#include <QToolButton>

namespace halbench::app {

/// Starts and ends the recording to a file, and says how long it runs.
class RecordButton : public QToolButton {
    Q_OBJECT

public:
    explicit RecordButton(Workbench& bench, QWidget* parent = nullptr);

    /// Short: one short word while it does not record.
    void setShort(bool isShort);
    int saved_px() const; ///< by being short
    /// Its width never changes while it records.
    QSize sizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void toggle(bool isWanted);
    void refresh();
    int time_px(bool isShort) const;
    QString runningWords(const QString& time, bool isShort) const;
    int room_px(bool isShort) const;
    static QString idleWords(bool isShort);

    Workbench& m_bench;
    bool m_isShort = false;
};

} // namespace halbench::app
