#pragma once

#include "app/window/preferences/preferences.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"

#include <QObject>

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QWidget;

namespace halbench::app {

/// The rows of the preferences on recordings: the mask of their names with an example, and how many are kept,
/// with what would go now. Changes nothing by itself. Thread: GUI.
class RecordingFields : public QObject {
    Q_OBJECT

public:
    RecordingFields(QFormLayout& form, const Preferences& preferences, Workbench& bench, QWidget* dialog);

    QString nameMask() const;
    RetentionLimits limits() const;
    /// The mask is one, and it was said what goes.
    bool isReady() const;

Q_SIGNALS:
    void changed();

private:
    struct Limit {
        QCheckBox* isOn = nullptr;
        QSpinBox* count = nullptr;
    };

    void addNames(QFormLayout& form, const QString& mask);
    void addKeeping(QFormLayout& form);
    Limit addLimit(const QString& words, const QString& unit, int most, int usual);
    void setLimit(Limit& limit, const std::optional<int>& count);
    void showNames();
    void showPlan();
    void say(const RetentionPlan& plan);

    Workbench& m_bench;
    QWidget* m_dialog;
    RetentionLimits m_before;
    QLineEdit* m_mask = nullptr;
    QLabel* m_example = nullptr;
    Limit m_days;
    Limit m_size;
    QLabel* m_plan = nullptr;
    LatestTask m_planning;
};

} // namespace halbench::app
