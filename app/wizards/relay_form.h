#pragma once

#include "app/procedures/relay/relay_procedure.h"

#include <QWidget>

#include <array>

class QFormLayout;
class QLabel;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// What the user may set of a relay experiment; an empty field leaves it to the program.
class RelayForm : public QWidget {
    Q_OBJECT
public:
    explicit RelayForm(QWidget* parent = nullptr);

    /// Without a motor. Error: InvalidInput for a field that shows no possible number. What the numbers mean
    /// together is judged by planRelay().
    Result<RelayConfig> config() const;

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Field { Base, Current, Cycles, Fields };

    void addRow(Field field, const QString& unit);
    void refreshWords();

    QFormLayout* m_form = nullptr;
    std::array<widgets::OptionalNumberEdit*, Fields> m_edits{};
    std::array<QLabel*, Fields> m_labels{};
};

} // namespace halbench::app
