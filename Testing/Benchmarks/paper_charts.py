# SPDX-License-Identifier: BSD-3-Clause
"""Charts of the paper's figures, drawn by matplotlib from the tables that vtkHashedOctreeFilter puts out. Each goes
into axes that are given."""
import numpy as np
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator, PercentFormatter

# The first two can be told apart by the colour-blind.
BLUE, RED, GREY, PALE, DARK = "#0072B2", "#D55E00", "#bbbbbb", "#eeeeee", "#222222"


def finish_chart(axes, title, x_label, y_label):
    axes.set_title(title)
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.grid(alpha=0.3)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def draw_depths(axes, point_set, colors):
    """Leaves of each depth: those with points in the colours of the scene, empty ones in grey."""
    depths, empty = point_set.histogram["Depth"], point_set.histogram["EmptyLeaves"]
    held = point_set.histogram["Leaves"] - empty
    axes.bar(depths, held, color=[colors.get(depth, GREY) for depth in depths], edgecolor=DARK, linewidth=0.5)
    axes.bar(depths, empty, bottom=held, color=PALE, edgecolor=DARK, linewidth=0.5)
    axes.set_ylim(0, 1.25 * point_set.histogram["Leaves"].max())
    axes.legend(handles=[Patch(facecolor=colors[max(colors, key=lambda depth: held[depth])], edgecolor=DARK,
                               label="with points (coloured as in the octree)"),
                         Patch(facecolor=PALE, edgecolor=DARK, label="empty")])
    axes.yaxis.set_major_formatter("{x:,.0f}")
    finish_chart(axes, "Leaves by depth", "depth (0 = root)", "leaves")


def draw_start_depths(axes, point_set):
    """The cost of each start depth, with the three that the paper's Figure 1 marks."""
    costs, deepest = point_set.costs["CostLeaves"], int(point_set.figures["DeepestDepth"])
    axes.plot(point_set.costs["StartDepth"], costs, "o-", color=GREY, markersize=4)
    # By shape: colours are depths in the panels beside.
    marks = [("top-down", 0, "o"), ("statistical", int(point_set.figures["StartDepthLeaves"]), "D"),
             ("bottom-up", deepest, "s")]
    for name, depth, marker in marks:
        axes.plot(depth, costs[depth], marker, color=DARK, markersize=11, linestyle="none",
                  label=f"{name}: from depth {depth}, {costs[depth]:.2f} nodes")
    axes.set_ylim(0, 1.35 * costs.max())
    axes.legend(loc="upper center")
    finish_chart(axes, "Cost of a search for a leaf", "start depth (0 = root)", "mean cost (nodes)")


def get_density(shares, samples=2000):
    """Depths, and the paper's p(l) there: over [l, l + 1] a parabola of area p_l that vanishes at both ends."""
    x = (np.arange(len(shares) * samples) + 0.5) / samples
    return x, 6 * shares[x.astype(int)] * (x % 1) * (1 - x % 1)


def draw_density(axes, point_set, colors):
    """The share of each depth as a bar, in the colours of a scene if there is one, and as a parabola."""
    shares = point_set.depth_shares()
    x, density = get_density(shares)
    depths = np.arange(len(shares))
    axes.bar(depths + 0.5, shares, width=1, color=[colors.get(depth, GREY) for depth in depths], edgecolor="white")
    density_line, = axes.plot(x, density, color=DARK, label="density $p(l)$, share per depth", linewidth=1.2)
    axes.set_ylim(0, 1.3 * density.max())
    share = Patch(facecolor=colors.get(shares.argmax(), GREY), label="share $p_l$ of the leaves")
    axes.legend(handles=[share, density_line], loc="upper left")
    finish_chart(axes, f"Density of depths, {point_set.name}", "depth $l$ (0 = root)", "share of the leaves")
    axes.yaxis.set_major_formatter(PercentFormatter(1, decimals=0))


def get_continuous_cost(shares, x):
    """The paper's differentiable cost at depths x inside the histogram: by the middles of the parabolas, but for the
    one in which x lies, whose mean distance from x is a polynomial."""
    whole, part = np.divmod(x, 1)
    far = np.abs(x[:, None] - np.arange(len(shares)) - 0.5) @ shares
    return 1 + far + shares[whole.astype(int)] * (2 * part ** 3 - part ** 4 - part + 0.5 - np.abs(part - 0.5))


def get_minimisers(point_set):
    """Of the discrete and of the continuous cost."""
    x, _ = get_density(point_set.depth_shares())
    return point_set.costs["CostLeaves"].argmin(), x[get_continuous_cost(point_set.depth_shares(), x).argmin()]


def draw_costs(axes, point_set, zoomed):
    """Both costs with their minimisers: of all start depths, or around the best."""
    shares, discrete = point_set.depth_shares(), point_set.costs["CostLeaves"]
    x, _ = get_density(shares)
    continuous = get_continuous_cost(shares, x)
    best, minimiser = get_minimisers(point_set)
    halves = point_set.costs["StartDepth"] + 0.5
    axes.plot(x, continuous, color=BLUE, label="continuous cost")
    axes.plot(halves, point_set.costs["ContinuousLeaves"], ".", color=BLUE, markersize=9,
              label=r"the filter's ContinuousLeaves, at depth + $\frac{1}{2}$")
    axes.plot(point_set.costs["StartDepth"], discrete, "o--", color=RED, label="discrete cost", linewidth=1)
    axes.plot(best, discrete[best], "D", color=RED, markersize=11, label=f"its minimiser: {best}")
    axes.plot(minimiser, continuous.min(), "D", color=BLUE, markersize=11,
              label=f"minimiser of the continuous: {minimiser:.2f}")
    axes.vlines([best, minimiser], 0, [discrete[best], continuous.min()], colors=[RED, BLUE], linestyles=":")
    if zoomed:
        axes.set_xlim(best - 1.6, best + 2.6)
        shown = discrete[max(best - 1, 0):best + 3]
        margin = 0.25 * (shown.max() - shown.min())
        axes.set_ylim(shown.min() - margin, shown.max() + margin)
    else:
        axes.set_ylim(0, 1.1 * continuous.max())
        axes.legend(loc="upper center")
    finish_chart(axes, "Around the minimisers" if zoomed else "All start depths", "start depth (0 = root)",
                 "mean cost (nodes)")
