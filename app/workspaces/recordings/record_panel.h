#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace halbench::widgets {
class MessageBar;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// Recording to a file with its state in view: time, rows, gaps (resources/help/monitor.md, "Recording").
class RecordPanel : public QWidget {
    Q_OBJECT

public:
    explicit RecordPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void marked(double device_s, const QString& note); ///< the recording has it

private:
    void buildTarget(QVBoxLayout& column);
    void buildMoment(QVBoxLayout& column);
    void buildState(QVBoxLayout& column);
    void toggle();
    void addMarker();
    double newestTime_s() const;
    void refresh();
    void showMoment();
    void showMask();
    void showChoice();
    void onFinished(const QString& path, const RecorderStatus& status);

    Workbench& m_bench;
    widgets::MessageBar* m_message = nullptr;
    QLineEdit* m_folder = nullptr;
    QLineEdit* m_name = nullptr;
    QComboBox* m_rate = nullptr;
    widgets::QuantityEdit* m_before = nullptr;
    QComboBox* m_start = nullptr;
    widgets::QuantityEdit* m_after = nullptr;
    QLabel* m_moment = nullptr;
    QPushButton* m_record = nullptr;
    QPushButton* m_mark = nullptr;
    QLineEdit* m_note = nullptr;
    QLabel* m_elapsed = nullptr;
    QLabel* m_rows = nullptr;
    QLabel* m_missing = nullptr;
};

} // namespace halbench::app
