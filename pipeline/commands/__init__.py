"""What the `debist` command shares: console output, progress, and the sub-commands of physics, rig and study."""
