"""Laws of the number format."""

import pytest

from socialnav_core.config.reading import read_config
from socialnav_core.training import precision


@pytest.mark.parametrize('wished', [True, False])
@pytest.mark.parametrize('available', [True, False])
def test_configuration_records_the_format_that_is_really_used(monkeypatch, wished, available):
    monkeypatch.setattr(precision, 'bfloat16_available', lambda: available)
    config = read_config('sarl', {'training.bfloat16': wished})
    assert precision.with_available_precision(config).training.bfloat16 == (wished and available)
