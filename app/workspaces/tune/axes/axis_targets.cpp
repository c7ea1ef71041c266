#include "app/workspaces/tune/axes/axis_targets.h"

#include "control/design/axis_designs.h"
#include "widgets/controls/optional_number_edit.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace halbench::app {

AxisTargets::AxisTargets(QFormLayout& form, QWidget* parent) : QObject(parent) {
    const auto add = [&](const char* key, std::optional<double> control::DesignTargets::*value) {
        auto* edit = new widgets::OptionalNumberEdit(parent);
        edit->setLimits({0.0, 1e6, false});
        auto* name = new QLabel(parent);
        form.addRow(name, edit);
        m_rows.push_back({name, edit, key, value});
        connect(edit, &widgets::OptionalNumberEdit::valueChanged, this, &AxisTargets::edited);
    };
    add("zeta", &control::DesignTargets::zeta);
    add("omega-rad-s", &control::DesignTargets::omega_rad_s);
    add("bandwidth-hz", &control::DesignTargets::bandwidth_Hz);
    add("phase-margin-deg", &control::DesignTargets::phaseMargin_deg);
}

void AxisTargets::showFor(const std::string& method) {
    const auto& methods = control::axisDesignMethods();
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const control::DesignMethod& each) { return each.name == method; });
    for (const Row& row : m_rows) {
        const bool isRead = found != methods.end() && found->targets.find(row.key) != std::string_view::npos;
        row.name->setVisible(isRead);
        row.edit->setVisible(isRead);
    }
}

void AxisTargets::setTargets(const control::DesignTargets& targets) {
    for (const Row& row : m_rows) {
        const QSignalBlocker quiet(row.edit);
        row.edit->setValue(targets.*row.value);
    }
}

control::DesignTargets AxisTargets::targets() const {
    control::DesignTargets targets;
    for (const Row& row : m_rows) {
        if (!row.edit->isHidden()) {
            targets.*row.value = row.edit->value();
        }
    }
    return targets;
}

void AxisTargets::refreshWords() {
    const QString names[] = {tr("damping ratio"), tr("frequency [rad/s]"), tr("bandwidth [Hz]"),
                             tr("phase margin [\u00b0]")};
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].name->setText(names[i]);
        m_rows[i].edit->setAccessibleName(names[i]);
        m_rows[i].edit->setPlaceholderText(tr("chosen by the method"));
    }
}

} // namespace halbench::app
