"""What the figures say in words: which policy to use, and how sure that is."""

from collections.abc import Sequence
import dataclasses

from socialnav_core.evaluation import Comparison, EvaluationResult
from socialnav_core.evaluation.statistics import Estimate

LEVEL = 0.05
"""A difference counts where chance would make it more seldom than this."""
FEW = 100
"""With fewer cases a warning is added."""


@dataclasses.dataclass(frozen=True)
class Verdict:
    """The first lines of the page."""

    headline: str
    """Which policy to use, on one line."""
    reasons: list[str]
    """A sentence or two for each world."""
    cautions: list[str]
    """What else whoever decides has to know."""


@dataclasses.dataclass(frozen=True)
class Standing:
    """How the policies of one world stand to each other."""

    title: str
    """What the world is called."""
    results: Sequence[EvaluationResult]
    """One of each policy, on the same cases."""
    comparisons: Sequence[Comparison]
    """One of each pair."""

    @property
    def ranked(self) -> list[EvaluationResult]:
        """Return the results, the highest success first; of two like ones, the first named."""
        return sorted(self.results, key=lambda result: -result.success_rate)

    def pair(self, first: str, second: str) -> tuple[float, Estimate | None]:
        """Return the adjusted p-value of two policies and first - second in time, s."""
        for each in self.comparisons:
            if (each.first, each.second) == (first, second):
                return each.adjusted_p_value, each.time_difference
            if (each.second, each.first) == (first, second):
                return each.adjusted_p_value, mirrored(each.time_difference)
        raise KeyError((first, second))

    def leaders(self, names: Sequence[str]) -> list[str]:
        """Return those of some policies that none of them beats in success beyond chance."""
        best = next(result.model for result in self.ranked if result.model in names)
        return [name for name in names if name == best or self.pair(best, name)[0] >= LEVEL]

    def is_faster(self, name: str, others: Sequence[str]) -> bool:
        """Return whether a policy is faster than each other one on the cases that both solved."""
        differences = [self.pair(name, other)[1] for other in others]
        return all(each is not None and each.high < 0.0 for each in differences)


def verdict(standings: Sequence[Standing]) -> Verdict:
    """Return what the figures of some worlds say."""
    reasons = [reason(standing) for standing in standings]
    return Verdict(headline(standings), reasons, cautions(standings))


def headline(standings: Sequence[Standing]) -> str:
    """Return which policy to use, on one line."""
    results = standings[0].results
    if len(results) == 1:
        [alone] = results
        rates = [f'{rate_of(each.results[0])} in {each.title}' for each in standings]
        return f'{alone.model} reached its goal in {listed(rates)}.'
    names = deployable(results)
    if len(names) == 1:
        return f'Use {names[0]}: what it is compared with knows the future, as no robot can.'
    leaders = [standing.leaders(names) for standing in standings]
    common = [name for name in names if all(name in each for each in leaders)]
    if not common:
        best = [f'{listed(each)} in {at.title}' for each, at in zip(leaders, standings,
                                                                    strict=True)]  # fmt: skip
        return f'It depends on the world: {"; ".join(best)}.'
    return choice(standings, leaders, common)


def choice(
    standings: Sequence[Standing], leaders: Sequence[Sequence[str]], common: Sequence[str]
) -> str:
    """
    Return the choice among the policies that no other beats in any world.

    :param leaders: in each world those that none beats there.
    :param common: at least one that leads everywhere.
    """
    where = 'in every world here' if len(standings) > 1 else f'in {standings[0].title}'
    if len(common) == 1:
        alone = [at.title for at, each in zip(standings, leaders, strict=True) if len(each) == 1]
        if len(alone) == len(standings):
            return f'Use {common[0]}: it reaches its goal most often {where}, beyond chance.'
        most = f'it reaches its goal most often in {listed(alone)}, and elsewhere ' * bool(alone)
        return f'Use {common[0]}: {most}none is better than it beyond chance.'
    for name in common:
        others = [other for other in common if other != name]
        if all(standing.is_faster(name, others) for standing in standings):
            return (
                f'Use {name}: success alone does not tell it from {listed(others)} {where}, '
                'but it arrives sooner.'
            )
    return (
        f'No clear choice between {listed(common)}: {where} neither success nor time tells them '
        'apart.'
    )


def reason(standing: Standing) -> str:
    """Return what the figures of one world say, in a few sentences."""
    ranked = standing.ranked
    first = ranked[0]
    rates = [f'{each.model} in {rate_of(each)}' for each in ranked]
    text = f'In {standing.title} ({cases_of(first)}) the goal was reached by {listed(rates)}.'
    if len(ranked) == 1:
        return f'{text} {failures_of(first)}'
    return ' '.join([text, *(against(standing, first, other) for other in ranked[1:])])


def against(standing: Standing, first: EvaluationResult, other: EvaluationResult) -> str:
    """Return how sure it is that one policy is better than another one, and which is faster."""
    p_value, time = standing.pair(first.model, other.model)
    if first.success_rate == other.success_rate:
        pair = f'{first.model} and {other.model}'
        return f'{pair} succeed equally often.{sooner(first.model, other.model, time)}'
    overlap = first.success_interval[0] <= other.success_interval[1]
    names = f'The intervals of {first.model} and {other.model}'
    certain = p_value < LEVEL
    finding = {
        (
            True,
            True,
        ): f'overlap, yet case by case the difference is beyond chance ({chance(p_value)})',
        (True, False): f'overlap, and the difference may be chance ({chance(p_value)})',
        (False, True): f'do not overlap, and the difference is beyond chance ({chance(p_value)})',
        (False, False): f'do not overlap, yet case by case it may be chance ({chance(p_value)})',
    }[overlap, certain]
    return f'{names} {finding}.{sooner(first.model, other.model, time)}'


def sooner(first: str, second: str, time: Estimate | None) -> str:
    """Return which of two arrives sooner, with a blank before; empty where that is unknown."""
    if time is None:
        return ''
    if time.low <= 0.0 <= time.high:
        return ' Neither arrives clearly sooner.'
    quick = first if time.mean < 0.0 else second
    low, high = sorted((abs(time.low), abs(time.high)))
    return f' Where both arrive, {quick} is {abs(time.mean):.2f} s sooner [{low:.2f}, {high:.2f}].'


def cautions(standings: Sequence[Standing]) -> list[str]:
    """Return what else whoever decides has to know."""
    results = standings[0].results
    told = [result.model for result in results if result.policy.knowledge == 'oracle']
    notes = [
        f'Told by the simulator what people will do: {listed(told)}. That is a yardstick, and no '
        'policy for a robot.'
    ] * bool(told)
    if results[0].episodes < FEW:
        low, high = widest(standings)
        notes.append(
            f'{cases_of(results[0])} are few: intervals of success are up to '
            f'{100 * (high - low):.0f} points wide.'
        )
    if results[0].split != 'test':
        notes.append(
            f'These are {results[0].split} cases: what was tuned on them looks better than it is.'
        )
    return notes


def widest(standings: Sequence[Standing]) -> tuple[float, float]:
    """Return the widest interval of a success rate."""
    intervals = [each.success_interval for at in standings for each in at.results]
    return max(intervals, key=lambda interval: interval[1] - interval[0])


def deployable(results: Sequence[EvaluationResult]) -> list[str]:
    """Return the policies that a robot can use; all where none can."""
    names = [result.model for result in results if result.policy.knowledge != 'oracle']
    return names or [result.model for result in results]


def failures_of(result: EvaluationResult) -> str:
    """Return how the cases ended that were not solved."""
    figures = result.summary()
    kinds = {
        'collisions with people': figures['collision_pedestrian_rate'],
        'collisions with obstacles': figures['collision_obstacle_rate'],
        'collisions with walls': figures['out_of_bounds_rate'],
        'time-outs': figures['timeout_rate'],
    }
    counts = [f'{round(rate * result.episodes)} {kind}' for kind, rate in kinds.items() if rate]
    return f'The others: {listed(counts)}.' if counts else 'It never failed.'


def rate_of(result: EvaluationResult) -> str:
    """Return a success rate with its interval, per cent."""
    low, high = result.success_interval
    return f'{100 * result.success_rate:.1f} % [{100 * low:.1f}, {100 * high:.1f}]'


def cases_of(result: EvaluationResult) -> str:
    """Return how many cases of which split there were."""
    return f'{result.episodes:,} {result.split} case{"s" * (result.episodes != 1)}'


def chance(value: float) -> str:
    """Return a p-value."""
    return 'p < 0.001' if value < 0.001 else f'p = {value:.2g}'


def mirrored(estimate: Estimate | None) -> Estimate | None:
    """Return second - first of first - second."""
    return estimate and Estimate(-estimate.mean, -estimate.high, -estimate.low)


def listed(words: Sequence[str]) -> str:
    """Return words as a sentence lists them."""
    return ' and '.join([', '.join(words[:-1])] * (len(words) > 1) + [*words[-1:]])
