"""Whether this processor multiplies bfloat16 numbers by itself."""

import dataclasses

import torch

from socialnav_core.config import Config, require


def bfloat16_available() -> bool:
    """Return whether bfloat16 products are faster than float32 ones here (AVX-512 BF16 or AMX)."""
    capabilities = torch.cpu.get_capabilities()
    return any(capabilities.get(name, False) for name in ('avx512_bf16', 'amx_bf16'))


def with_available_precision(config: Config) -> Config:
    """
    Return the configuration with the precision that is really used on this machine.

    :param config: training.bfloat16 is what was wished.
    :raises ConfigError: when training.device is not there.
    """
    on_gpu = config.training.device == 'cuda'
    require(
        not on_gpu or torch.cuda.is_available(),
        'training.device: cuda needs a CUDA GPU and a CUDA build of torch; use cpu',
    )
    used = config.training.bfloat16 and (on_gpu or bfloat16_available())
    return dataclasses.replace(
        config, training=dataclasses.replace(config.training, bfloat16=used)
    )
