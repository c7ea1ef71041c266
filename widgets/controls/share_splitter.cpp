#include "widgets/controls/share_splitter.h"

#include <QEvent>
#include <QResizeEvent>
#include <QSplitterHandle>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double Grain = 100.0;      ///< of a share: a percent
constexpr double PerShare = 10000.0; ///< a splitter makes pixels of it

/// A double click makes all parts equally large.
class ShareHandle : public QSplitterHandle {
public:
    explicit ShareHandle(ShareSplitter& splitter)
        : QSplitterHandle(splitter.orientation(), &splitter), m_splitter(splitter) {
        setToolTip(ShareSplitter::tr("Drag to change the sizes; double-click for equal sizes"));
    }

protected:
    void mouseDoubleClickEvent(QMouseEvent* /*event*/) override { m_splitter.shareEvenly(); }

private:
    ShareSplitter& m_splitter;
};

} // namespace

std::vector<double> settledShares(std::vector<double> shares) {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    const double mean = shares.empty() ? 0.0 : sum / static_cast<double>(shares.size());
    for (double& share : shares) {
        share = mean > 0.0 ? std::max(1.0, std::round(Grain * share / mean)) / Grain : 1.0;
    }
    return shares;
}

ShareSplitter::ShareSplitter(Qt::Orientation orientation, QWidget* parent) : QSplitter(orientation, parent) {
    setChildrenCollapsible(false);
    connect(this, &QSplitter::splitterMoved, this, &ShareSplitter::take);
}

QSplitterHandle* ShareSplitter::createHandle() {
    return new ShareHandle(*this);
}

void ShareSplitter::setShares(std::vector<double> shares) {
    m_shares = std::move(shares);
    apply();
}

void ShareSplitter::apply() {
    QList<int> sizes;
    for (int i = 0; i < count(); ++i) {
        const bool isKnown = m_shares.size() == static_cast<std::size_t>(count());
        const double share = isKnown ? m_shares[static_cast<std::size_t>(i)] : 1.0;
        sizes << static_cast<int>(std::lround(PerShare * share));
    }
    setSizes(sizes);
}

/// A part that needed more for a while gives it back.
bool ShareSplitter::event(QEvent* event) {
    const bool isTaken = QSplitter::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        apply();
    }
    return isTaken;
}

void ShareSplitter::resizeEvent(QResizeEvent* event) {
    QSplitter::resizeEvent(event);
    apply();
}

/// Sizes that differ by the pixel that cannot be shared are equal.
std::vector<double> ShareSplitter::shownShares() const {
    const QList<int> shown = sizes();
    const auto [least, most] = std::minmax_element(shown.begin(), shown.end());
    if (shown.isEmpty() || *most - *least <= 1) {
        return std::vector<double>(static_cast<std::size_t>(shown.size()), 1.0);
    }
    return settledShares(std::vector<double>(shown.begin(), shown.end()));
}

void ShareSplitter::take() {
    m_shares = shownShares();
    Q_EMIT sharesChanged();
}

bool ShareSplitter::grow(int part, double factor) {
    if (part < 0 || part >= count() || count() < 2) {
        return false;
    }
    const QList<int> before = sizes();
    std::vector<double> wanted(before.begin(), before.end());
    wanted[static_cast<std::size_t>(part)] *= factor;
    setShares(settledShares(std::move(wanted)));
    take(); // as far as there was room
    return sizes() != before;
}

void ShareSplitter::shareEvenly() {
    setShares(std::vector<double>(static_cast<std::size_t>(count()), 1.0));
    Q_EMIT sharesChanged();
}

} // namespace halbench::widgets
