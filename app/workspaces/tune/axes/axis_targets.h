#pragma once

#include "control/design/design_methods.h"

#include <QObject>

#include <optional>
#include <string>
#include <vector>

class QFormLayout;
class QLabel;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// Rows of a form with the targets of a design method; only those that the method reads are shown. The rows
/// belong to the form. Thread: GUI.
class AxisTargets : public QObject {
    Q_OBJECT
public:
    AxisTargets(QFormLayout& form, QWidget* parent);

    /// Of control::axisDesignMethods(); any other reads none.
    void showFor(const std::string& method);
    void setTargets(const control::DesignTargets& targets);
    control::DesignTargets targets() const; ///< those that are shown
    void refreshWords();

Q_SIGNALS:
    void edited(); ///< by the user

private:
    struct Row {
        QLabel* name;
        widgets::OptionalNumberEdit* edit;
        const char* key; ///< of control::DesignMethod::targets
        std::optional<double> control::DesignTargets::*value;
    };
    std::vector<Row> m_rows;
};

} // namespace halbench::app
