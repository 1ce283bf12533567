"""Settings of all tests: the same random cases in every run, or many with BLOSSOM_EXAMPLES."""

import os

from hypothesis import HealthCheck, settings

settings.register_profile(
    "tests",
    derandomize=True,
    deadline=None,
    max_examples=int(os.environ.get("BLOSSOM_EXAMPLES", 60)),
    suppress_health_check=[HealthCheck.too_slow],
    database=None,
)
settings.load_profile("tests")
