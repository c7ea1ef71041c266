#include "app/workspaces/tune/loop/tune_form.h"

#include "app/documents/presets.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "control/design/optimal_designs.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>

namespace halbench::app {
namespace {

using control::DesignTargets;

struct TargetField {
    const char* name; ///< as DesignMethod::targets writes it
    std::optional<double> DesignTargets::*place;
    const char* unit;
    double most;
    double least = 0.0; ///< not itself when it is 0
};
constexpr std::array TargetFields = {
    TargetField{"zeta", &DesignTargets::zeta, "", 10.0},
    TargetField{"omega-rad-s", &DesignTargets::omega_rad_s, "rad/s", 1e4},
    TargetField{"bandwidth-hz", &DesignTargets::bandwidth_Hz, "Hz", 1e4},
    TargetField{"phase-margin-deg", &DesignTargets::phaseMargin_deg, "\u00b0", 90.0},
    TargetField{"max-sensitivity", &DesignTargets::mostMs_ratio, "", control::least_error::MostMs_ratio,
                control::least_error::LeastMs_ratio},
    TargetField{"current-limit-a", &DesignTargets::currentLimit_A, "A", 1e3},
    TargetField{"step-deg", &DesignTargets::step_deg, "\u00b0", 360.0},
    TargetField{"ultimate-gain", &DesignTargets::ultimateGain_A_per_rad, "A/rad", 1e5},
    TargetField{"ultimate-period", &DesignTargets::ultimatePeriod_s, "s", 1e3}};

constexpr int OriginRole = Qt::UserRole;
constexpr int IdRole = Qt::UserRole + 1;

const control::DesignMethod* methodNamed(const std::string& name) {
    const auto& methods = control::designMethods();
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const control::DesignMethod& method) { return method.name == name; });
    return found == methods.end() ? nullptr : &*found;
}

bool reads(const control::DesignMethod* method, const char* target) {
    return method != nullptr && method->targets.find(target) != std::string_view::npos;
}

} // namespace

TuneForm::TuneForm(QWidget* parent)
    : QWidget(parent), m_label(new QLabel(this)), m_origin(new QComboBox(this)), m_help(new QLabel(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(widgets::PanelMargin_px);
    grid->setVerticalSpacing(widgets::GridStep_px);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_label, 0, 0);
    grid->addWidget(m_origin, 0, 1, 1, 2);
    grid->addWidget(m_help, 1, 0, 1, 3);
    m_label->setBuddy(m_origin);
    setFocusProxy(m_origin);
    m_help->setWordWrap(true);
    widgets::setRole(*m_help, widgets::Role::Muted);
    m_origin->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_origin->setMinimumContentsLength(14);
    for (const control::DesignMethod& method : control::designMethods()) {
        addOrigin(Origin::Method, std::string(method.name));
    }
    for (const std::string& preset : presetNames()) {
        addOrigin(Origin::Preset, preset);
    }
    addOrigin(Origin::Device, "device");
    addOrigin(Origin::Edited, "edited");
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        Target target{new QLabel(this), new widgets::OptionalNumberEdit(this),
                      new QLabel(QString::fromUtf8(TargetFields[i].unit), this)};
        target.edit->setLimits({TargetFields[i].least, TargetFields[i].most, TargetFields[i].least > 0.0});
        target.edit->setObjectName(QString::fromLatin1(TargetFields[i].name));
        target.name->setBuddy(target.edit);
        widgets::setRole(*target.unit, widgets::Role::Muted);
        const int line = static_cast<int>(i) + 2;
        grid->addWidget(target.name, line, 0);
        grid->addWidget(target.edit, line, 1);
        grid->addWidget(target.unit, line, 2);
        connect(target.edit, &widgets::OptionalNumberEdit::valueChanged, this, &TuneForm::chosen);
        m_targets[i] = target;
    }
    connect(m_origin, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
        refreshTargets();
        Q_EMIT chosen();
    });
    refreshWords();
    refreshTargets();
}

void TuneForm::addOrigin(Origin origin, const std::string& id) {
    m_origin->addItem({});
    m_origin->setItemData(m_origin->count() - 1, static_cast<int>(origin), OriginRole);
    m_origin->setItemData(m_origin->count() - 1, QString::fromStdString(id), IdRole);
}

TuneForm::Origin TuneForm::origin() const {
    return static_cast<Origin>(m_origin->currentData(OriginRole).toInt());
}

std::string TuneForm::method() const {
    return m_origin->currentData(IdRole).toString().toStdString();
}

Result<control::DesignTargets> TuneForm::targets() const {
    DesignTargets targets;
    const control::DesignMethod* method = origin() == Origin::Method ? methodNamed(this->method()) : nullptr;
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        if (!reads(method, TargetFields[i].name)) {
            continue;
        }
        const widgets::OptionalNumberEdit& edit = *m_targets[i].edit;
        if (!edit.isValid()) {
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(edit.accessibleName(), edit.problem()).toStdString(),
                           tr("Correct it or leave it empty").toStdString());
        }
        targets.*TargetFields[i].place = edit.value();
    }
    return targets;
}

void TuneForm::setModel(const std::string& model) {
    if (m_model != model) {
        m_model = model;
        refreshWords();
    }
}

void TuneForm::setEdited() {
    const QSignalBlocker quiet(m_origin);
    m_origin->setCurrentIndex(m_origin->count() - 1);
    refreshTargets();
}

void TuneForm::showChoice(const std::string& id, const control::DesignTargets& targets) {
    const QSignalBlocker quiet(this);
    const int found = m_origin->findData(QString::fromStdString(id), IdRole);
    m_origin->setCurrentIndex(found >= 0 ? found : m_origin->count() - 1);
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        m_targets[i].edit->setValue(targets.*TargetFields[i].place);
    }
    refreshTargets();
}

void TuneForm::choose(const std::string& id, const control::DesignTargets& targets) {
    showChoice(id, targets);
    Q_EMIT chosen();
}

void TuneForm::refreshTargets() {
    const control::DesignMethod* method = origin() == Origin::Method ? methodNamed(this->method()) : nullptr;
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        const bool isRead = reads(method, TargetFields[i].name);
        for (QWidget* part :
             std::initializer_list<QWidget*>{m_targets[i].name, m_targets[i].edit, m_targets[i].unit}) {
            part->setVisible(isRead);
        }
    }
    m_help->setText(m_origin->currentData(Qt::ToolTipRole).toString());
}

void TuneForm::refreshWords() {
    m_label->setText(tr("Gain so&urce"));
    m_origin->setAccessibleName(tr("Source of the gains"));
    m_origin->setToolTip(tr("Design method, built-in preset or device values"));
    for (int i = 0; i < m_origin->count(); ++i) {
        const QString id = m_origin->itemData(i, IdRole).toString();
        QString text;
        QString help;
        switch (static_cast<Origin>(m_origin->itemData(i, OriginRole).toInt())) {
        case Origin::Method:
            text = tr("Method: %1").arg(designTitle(id.toStdString()));
            help = widgets::inWords(std::string(methodNamed(id.toStdString())->summary));
            break;
        case Origin::Preset:
            text = tr("Preset: %1").arg(designTitle(id.toStdString()));
            if (const auto preset = findPreset(m_model, id.toStdString())) {
                help = widgets::inWords(preset->title);
            }
            break;
        case Origin::Device:
            text = tr("Device values");
            help = tr("gains active on the device");
            break;
        case Origin::Edited:
            text = tr("Edited manually");
            help = tr("values below");
            break;
        }
        m_origin->setItemText(i, text);
        m_origin->setItemData(i, help, Qt::ToolTipRole);
    }
    const QString has = tr("Target of the design; empty: default of the method");
    const QString swings = tr("From the relay experiment; empty: from the model");
    const struct {
        QString name, otherwise, help;
    } words[] = {{tr("Damping ratio"), tr("default"), has},
                 {tr("Frequency"), tr("default"), has},
                 {tr("Bandwidth"), tr("default"), has},
                 {tr("Phase margin"), tr("default"), has},
                 {tr("Maximum Ms"), widgets::numberText(control::least_error::UsualMs_ratio, 3),
                  tr("Limit of the sensitivity peak: 1.4 robust, 2 fast. The Numbers page shows whether this "
                     "limit is active")},
                 {tr("Current limit"), tr("device limit"),
                  tr("Current allowed in a step of the height below; at most the device limit")},
                 {tr("Step height"), widgets::numberText(control::least_error::UsualStep_deg, 3),
                  tr("Largest reference step without current saturation")},
                 {tr("Ultimate gain"), tr("default"), swings},
                 {tr("Ultimate period"), tr("default"), swings}};
    for (std::size_t i = 0; i < m_targets.size(); ++i) {
        m_targets[i].name->setText(words[i].name);
        m_targets[i].edit->setAccessibleName(words[i].name);
        m_targets[i].edit->setPlaceholderText(words[i].otherwise);
        m_targets[i].edit->setExplanation(words[i].help);
    }
    refreshTargets();
}

void TuneForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

Result<control::PositionLaw> presetLaw(const std::string& model, const std::string& name) {
    const auto preset = findPreset(model, name);
    if (!preset) {
        return failure(preset.error());
    }
    std::map<std::string, double> values;
    for (const ParameterValue& value : preset->values) {
        values[value.name] = value.value;
    }
    return lawFromParameters(values);
}

} // namespace halbench::app
